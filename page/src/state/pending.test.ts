// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { beforeRun, settled } from "./pending.ts";

it("leaves the field that is typed in, then waits for what is to be done", async () => {
  const done: string[] = [];
  const field = document.body.appendChild(document.createElement("input"));
  field.addEventListener("blur", () => done.push("left"));
  field.focus();
  beforeRun(async () => {
    await Promise.resolve();
    done.push("saved");
  });
  await settled();
  expect(done).toEqual(["left", "saved"]);
});
