/** What is in the folder, and in the shipped library. */
import { signal } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { hear, whenOpen } from "../connection/stream.ts";

export type ModelKind = "line" | "pantograph" | "scenario" | "study";

export interface ModelEntry {
  /** Below the folder, with slashes; of a shipped model `shipped:KIND/NAME`. */
  path: string;
  kind: ModelKind;
  name: string;
  description: string;
  /** Files of the folder that it names; not of a shipped model. */
  names?: string[];
  /** Why the file cannot be read. */
  error?: string;
}

export interface MainNumbers {
  name: string;
  mean_force_N: number | null;
  std_force_N: number | null;
  max_force_N: number | null;
  min_force_N: number | null;
  NQ_percent: number | null;
}

/** A run on the disk, as `arcless runs --json` lists it. */
export interface RunEntry {
  path: string;
  verdict: "met" | "not met" | "not judged" | "stopped early" | "unreadable";
  reason: string | null;
  name: string | null;
  created: string | null;
  /** Name of its line, and a digest of what that says. */
  line: string | null;
  line_digest: string | null;
  speed_m_s: number | null;
  changes: Record<string, string>;
  pantographs: MainNumbers[];
  worst: string | null;
  max_uplift_at_support_mm: number | null;
}

export interface StudyEntry {
  path: string;
  name: string;
  done: number;
  planned: number | null;
}

export interface MeasuredEntry {
  path: string;
  bytes: number;
}

export interface ProjectView {
  /** Its last part, and all of it. */
  name: string;
  folder: string;
  version: string;
  models: ModelEntry[];
  library: ModelEntry[];
  runs: RunEntry[];
  studies: StudyEntry[];
  measured: MeasuredEntry[];
}

export const project = signal<ProjectView | null>(null);

/** A text of the server with paths as the project has them, below its folder. */
export function below(text: string): string {
  const folder = project.peek()?.folder;
  return folder ? text.replaceAll(`${folder}/`, "") : text;
}

export async function readProject(): Promise<void> {
  project.value = await ask<ProjectView>("project");
}

/** Follow changes of the folder, whoever makes them. */
export function followProject(): void {
  whenOpen(() => void readProject());
  hear("project", () => void readProject());
}
