/** A canvas that is as large as its place, sharp on any screen, and drawn when `redraw` is called. */
import { effect } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";
import { drawing, redraw } from "./scene.ts";

/** Colours by the names of tokens, as they are now: light or dark. */
export function colours(element: Element): (name: string) => string {
  const style = getComputedStyle(element);
  const known = new Map<string, string>();
  return (name) => {
    const found = known.get(name) ?? style.getPropertyValue(`--${name.replaceAll("_", "-")}`).trim();
    known.set(name, found);
    return found;
  };
}

export interface Sheet {
  context: CanvasRenderingContext2D;
  /** In px of CSS. */
  width: number;
  height: number;
  colour: (name: string) => string;
}

/**
 * Have `paint` draw on a canvas whenever its size, a signal that it reads, or a motion changes;
 * `again` draws it for another reason.
 */
export function useCanvas(
  canvas: RefObject<HTMLCanvasElement | null>,
  paint: (sheet: Sheet) => void,
  again?: { current: () => void },
): void {
  useEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return;
    const draw = () => {
      const { clientWidth: width, clientHeight: height } = element;
      const ratio = window.devicePixelRatio || 1;
      if (element.width !== Math.round(width * ratio)) element.width = Math.round(width * ratio);
      if (element.height !== Math.round(height * ratio)) element.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, width, height);
      if (width && height) paint({ context, width, height, colour: colours(element) });
    };
    if (again) again.current = draw;
    const sized = new ResizeObserver(redraw);
    sized.observe(element);
    const scheme = new MutationObserver(redraw);
    scheme.observe(document.documentElement, { attributeFilter: ["data-scheme"] });
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", redraw);
    const end = effect(() => {
      void drawing.value;
      draw();
    });
    return () => {
      sized.disconnect();
      scheme.disconnect();
      dark.removeEventListener("change", redraw);
      end();
    };
  }, []);
}
