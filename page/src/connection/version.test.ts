// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";
import { isMissingPart, look, updated } from "./version.ts";

const page = (name: string) => `<script type="module" crossorigin src="./assets/${name}"></script>`;

it("tells its own page from that of another version", async () => {
  // Without a source it is not fetched; its name is what counts.
  document.body.innerHTML = '<script type="module"></script>';
  const script = document.querySelector("script")!;
  script.getAttribute = (name: string) => (name === "src" ? "./assets/index-a.js" : null);
  const answer = vi.fn<() => Promise<Response>>();
  vi.stubGlobal("fetch", answer);
  answer.mockResolvedValueOnce(new Response(page("index-a.js")));
  expect(await look()).toBe(false);
  // A server that is gone, or refuses, says nothing of its page.
  answer.mockRejectedValueOnce(new TypeError("Failed to fetch"));
  expect(await look()).toBe(false);
  answer.mockResolvedValueOnce(new Response("locked", { status: 403 }));
  expect(await look()).toBe(false);
  answer.mockResolvedValueOnce(new Response(page("index-b.js")));
  expect(await look()).toBe(true);
  expect(updated.value).toBe(true);
});

it("knows a part of the page that could not be fetched", () => {
  expect(isMissingPart(new TypeError("Failed to fetch dynamically imported module: http://127.0.0.1/a.js"))).toBe(true);
  expect(isMissingPart(new Error("Unable to preload CSS for /assets/a.css"))).toBe(true);
  expect(isMissingPart(new TypeError("Failed to fetch"))).toBe(false);
});
