/**
 * A motion pulled from the stream into a store: one question at a time, asked again after a lost
 * connection. Times in s of the run.
 */
import { connection, hear, take, tell, whenOpen, type Message } from "../../connection/stream.ts";
import type { Source } from "../../state/selection.ts";
import type { Store } from "./store.ts";
import { lastAt } from "./track.ts";
import type { History } from "./history.ts";
import { wanted, type Situation, type Wish } from "./wanted.ts";

export interface Channel {
  number: number;
  name: string;
  unit: string;
  shape: number[];
  about: { text?: string; name?: string; values?: { name: string; unit: string }[] };
}

/** What the server says of a source when it is opened. */
export interface Opened {
  channels: Channel[];
  start_s: number;
  end_s: number;
  /** No more rows will come. */
  final: boolean;
  /** Interval of its rows; 0 where it is not known. */
  every_s: number;
  /** Whether wires move. */
  wires: boolean;
  /** The run began again: a static force did not give the mean force. What was sent is void. */
  again?: boolean;
  /** Which attempt of a search for the static force it is, from 1; `null`: it is the run. */
  search?: number | null;
  /** End of the whole run, of one that is being computed. */
  estimated_end_s?: number;
}

export interface Listener {
  opened(about: Opened): void;
  edge(end_s: number, final: boolean): void;
  /** Frames have come, or a question was answered. */
  changed(): void;
  failed(text: string): void;
  /** The source is not there any more: what was received is all. */
  closed(text: string): void;
}

interface Question extends Wish {
  number: number;
  asked: number;
}

/** Without an answer for so long a question is asked again: the server was stopped. ms */
const PATIENCE = 5000;
/** Rows farther apart than so many intervals: one was dropped between them. */
const GAP = 1.6;

let count = 0;

const same = (a: unknown, b: Source): boolean => JSON.stringify(a) === JSON.stringify(b);

export class Pull {
  private asked: Question | null = null;
  private takers: (() => void)[] = [];
  private readonly ends: (() => void)[];
  /** The edge at which an answer held nothing new: it is not asked again before the edge moves. */
  private dry: Wish | null = null;

  constructor(
    readonly source: Source,
    readonly store: Store,
    private readonly history: History,
    private readonly listener: Listener,
  ) {
    const mine = (act: (message: Message) => void) => (message: Message) => {
      if (same(message["source"], source)) act(message);
    };
    this.ends = [
      hear("channels", mine((message) => this.announced(message as unknown as Opened))),
      hear("edge", mine((message) => listener.edge(message["end_s"] as number, message["final"] as boolean))),
      hear("sent", mine((message) => this.answered(message))),
      hear("error", mine((message) => this.refused(message["about"], message["text"] as string))),
      whenOpen(() => {
        this.asked = null;
        tell({ topic: "play", source });
      }),
    ];
  }

  /** Play again: after a socket was lost, and where a source has something new. */
  private announced(about: Opened): void {
    if (about.again) {
      this.store.clear();
      this.history.clear();
    }
    for (const end of this.takers) end();
    this.takers = about.channels.map(({ number, name }) =>
      take(number, ({ time, first, values }) => {
        this.store.add(name, time, { first, values });
        if (name === "supports") this.history.addSupports(first, values);
        else if (name.startsWith("pantograph.")) this.history.addPantograph(Number(name.slice(11)), values);
        this.listener.changed();
      }),
    );
    this.asked = null;
    this.listener.opened(about);
  }

  private refused(about: unknown, text: string): void {
    if (about !== "play") return this.listener.failed(text);
    for (const end of this.takers) end();
    this.takers = [];
    this.listener.closed(text);
  }

  private answered(message: Message): void {
    const question = this.asked;
    if (!question || message["ask"] !== question.number) return;
    this.asked = null;
    const to = Math.min(message["to_s"] as number, question.to_s);
    const whole = message["dropped"] === 0;
    const end = whole ? to : this.unbroken(question);
    if (end > question.from_s) this.store.cover({ from: question.from_s, to: end, every: question.every_s });
    else if (whole) this.dry = question;
    this.listener.changed();
  }

  /** How far moments follow one another without a gap. */
  private unbroken({ from_s, to_s, every_s }: Wish): number {
    const times = this.store.moments;
    let at = Math.max(lastAt(times, from_s), 0);
    const least = times[at + 1] === undefined ? 0 : times[at + 1]! - times[at]!;
    const gap = GAP * Math.max(every_s, least);
    while (times[at + 1] !== undefined && times[at + 1]! <= to_s && times[at + 1]! - times[at]! <= gap) at++;
    return times[at] ?? from_s;
  }

  /** Whether a question waits in vain, or the clock jumped to where nothing is. */
  private isOld({ from_s, to_s, asked, every_s }: Question, { time }: Situation): boolean {
    if (performance.now() - asked > PATIENCE) return true;
    return (time < from_s || time > to_s) && this.store.reach(time, 1, every_s) <= time;
  }

  /** Ask for what is needed next. */
  update(now: Situation): void {
    if (connection.peek() !== "open" || !this.takers.length) return;
    this.store.trim(now.time);
    if (this.asked && !this.isOld(this.asked, now)) return;
    const wish = wanted(this.store, now);
    if (!wish || (this.dry && wish.from_s === this.dry.from_s && wish.to_s === this.dry.to_s)) return;
    this.asked = { ...wish, number: ++count, asked: performance.now() };
    tell({ topic: "want", source: this.source, ...wish, ask: this.asked.number });
  }

  close(): void {
    for (const end of [...this.ends, ...this.takers]) end();
    tell({ topic: "leave", source: this.source });
  }
}
