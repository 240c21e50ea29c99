/** Questions to the server: JSON in and out, and its complaints as errors. */

/** What the server says of a mistake: what, where, what was given, what is expected, a hint. */
export interface Complaint {
  text: string;
  what?: string;
  where?: string;
  got?: string;
  expected?: string;
  hint?: string;
  field?: (string | number)[];
  /** Counted from 1. */
  line?: number;
  column?: number;
  /** Of a step that failed: when, in s, and where the pantographs were along the track, in m, by name. */
  time_s?: number;
  positions_m?: Record<string, number>;
}

export class RefusedError extends Error {
  override name = "RefusedError";
  constructor(
    readonly status: number,
    readonly complaint: Complaint,
    /** The whole answer: a conflict also has the text that is on the disk. */
    readonly answer: unknown,
  ) {
    super(complaint.text);
  }
}

export interface Question {
  method?: "GET" | "POST" | "PUT";
  /** Sent as JSON. */
  body?: unknown;
  /** Sent as it is. */
  raw?: BodyInit;
  /** Parts of the address behind the question mark. */
  query?: Record<string, string | number | boolean | undefined>;
  signal?: AbortSignal;
}

function address(path: string, query: Question["query"]): string {
  const given = Object.entries(query ?? {}).filter(([, value]) => value !== undefined);
  const text = new URLSearchParams(given.map(([key, value]) => [key, String(value)])).toString();
  return `api/${path}${text ? `?${text}` : ""}`;
}

export async function answered(path: string, question: Question): Promise<Response> {
  const { method = question.body === undefined ? "GET" : "POST", body, raw, query, signal } = question;
  const response = await fetch(address(path, query), {
    method,
    credentials: "same-origin",
    ...(body === undefined ? {} : { body: JSON.stringify(body), headers: { "Content-Type": "application/json" } }),
    ...(raw === undefined ? {} : { body: raw }),
    ...(signal ? { signal } : {}),
  });
  if (response.ok) return response;
  const answer: unknown = await response.json().catch(() => null);
  const complaint = (answer as { error?: Complaint } | null)?.error ?? {
    text: `The server answered ${response.status} ${response.statusText}`,
  };
  throw new RefusedError(response.status, complaint, answer);
}

/** Ask the server at `api/PATH`; a refusal is a `RefusedError`. */
export async function ask<Answer>(path: string, question: Question = {}): Promise<Answer> {
  return (await answered(path, question)).json() as Promise<Answer>;
}

/** Ask for numbers as bytes, little-endian. */
export async function askBytes(path: string, question: Question = {}): Promise<ArrayBuffer> {
  return (await answered(path, question)).arrayBuffer();
}

/**
 * Of questions that follow one another the newest wins: an older one is aborted, and its answer is
 * `undefined`.
 */
export function newest<Given extends unknown[], Answer>(
  question: (signal: AbortSignal, ...given: Given) => Promise<Answer>,
): (...given: Given) => Promise<Answer | undefined> {
  let current: AbortController | undefined;
  return async (...given) => {
    current?.abort();
    const mine = (current = new AbortController());
    try {
      const answer = await question(mine.signal, ...given);
      return mine.signal.aborted ? undefined : answer;
    } catch (error) {
      if (mine.signal.aborted) return undefined;
      throw error;
    }
  };
}
