/** Numbers as bytes, with what they are in the header `X-About`. */
import { answered, type Question } from "./http.ts";

export interface Numbers<About> {
  /** Singles, little-endian. */
  values: Float32Array;
  about: About;
}

export async function askNumbers<About>(
  path: string,
  query: NonNullable<Question["query"]>,
  signal?: AbortSignal,
): Promise<Numbers<About>> {
  const response = await answered(path, { query, ...(signal ? { signal } : {}) });
  const about = JSON.parse(response.headers.get("X-About") ?? "null") as About;
  return { values: new Float32Array(await response.arrayBuffer()), about };
}
