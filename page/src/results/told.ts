/** What the server tells of runs and comparisons: the content of reports, as texts. */
import type { Complaint } from "../connection/http.ts";
import type { Section } from "../charts/figure.ts";

export type State = "met" | "missed" | "open";

export interface Criterion {
  name: string;
  title: string;
  pantograph: string;
  value: string;
  limit: string;
  margin: string;
  unit: string;
  verdict: string;
  state: string;
  mark: string;
  source: string;
  note: string;
  reason: string;
}

/** Label, unit, and a value for each pantograph, or one of the line. */
export type NumberRow = [string, string, string[]];

export interface Assessed {
  title: string;
  description: string;
  identity: [string, string][];
  verdict: { state: State; sign: string; text: string; rest: string; items: string[] };
  /** The criterion behind the verdict; null where none has a value and a limit. */
  leading: Criterion | null;
  /** Section of the verdict, and its spans. */
  judged_on: string;
  worst: string;
  criteria: Criterion[];
  marks: Record<string, string>;
  marks_mean: string;
  pantographs: string[];
  numbers: [NumberRow[], NumberRow[]];
  numbers_of: string;
  certainty: boolean;
  notes: string[];
  warnings: string[];
  stopped_m: number | null;
  version: string;
  other_version: boolean;
  report: boolean;
}

export interface Figures {
  sections: Section[];
  section_m: [number, number];
  supports_m: number[];
}

/** A row of a table: a value of each run, with its difference to the first one. */
export interface Compared {
  label: string;
  unit: string;
  pantograph: string;
  cells: string[][];
}

export interface Acceptance {
  run: string;
  measurement: string;
  rows: {
    label: string;
    unit: string;
    pantograph: string;
    /** Simulated, measured, difference, tolerance with its mark, within. */
    cells: [string, string, string, string, string];
    within: boolean | null;
    source: string;
  }[];
}

export interface Comparison {
  title: string;
  names: string[];
  colours: string[];
  runs: { name: string; verdict: string; state: string; speed: string; section: string; scenario: string }[];
  warnings: string[];
  several: boolean;
  simulated: number;
  fields: { path: string; values: (string | null)[] }[];
  verdicts: { title: string; unit: string; pantograph: string; cells: [string, string, string][] }[];
  placement: { run: number; pantograph: string; cells: string[] }[];
  bands: (Compared & { kind: string })[];
  acceptance: Acceptance[];
  main: Compared[];
  numbers: Compared[];
  differences_read: string;
  numbers_read: string;
  placement_reads: string;
  /** Name of the run that measurements lie on; null where there is none. */
  placed_on: string | null;
  /** What became better and worse of each run but the first, a sentence each. */
  changes: string[];
  /** What is compared, in m. */
  section_m: [number, number];
  bands_read: string;
  acceptance_reads: string;
  left_out: string;
  same: string;
  sections: Section[];
}

export interface Place {
  position_m: number;
  time_s: number;
  span: number | null;
  force_N: number;
  deviation_N: number;
  where: string;
  as_built: string | null;
}

export interface Explanation {
  /** Why there is none; then there is nothing else. */
  refused?: Complaint;
  sentences: string[];
  notes: string[];
  section_m: [number, number];
  pantographs: {
    name: string;
    mean_force_N: number;
    std_force_N: number;
    groups: {
      key: string;
      name: string;
      share_percent: number;
      std_N: number;
      uncertainty_percent: number | null;
      strongest: { frequency_Hz: number; wavelength_m: number | null; share_percent: number } | null;
    }[];
    by_span: { span: number; begin_m: number; end_m: number; std_N: number }[];
    worst: Place[];
    irregular: Place[];
  }[];
}
