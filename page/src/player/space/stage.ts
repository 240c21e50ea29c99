/** The line in space by three.js: vertices of a part of it, moved with the state; lengths in m. */
import {
  BoxGeometry, BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, LineDashedMaterial, LineSegments,
  Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer, type Material,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Geometry, WireKind } from "../../drawing/geometry.ts";
import { indexOf } from "../../drawing/lineIndex.ts";
import type { MotionState } from "../motion/state.ts";
import { colourOf } from "../views/pantographs.ts";
import { HALF, holds, moveWire, sectionAround, writeSegment, type Section } from "./section.ts";

const COLOURS: Record<WireKind, string> = {
  contact: "contact_wire", messenger: "messenger_wire", auxiliary: "auxiliary_wire", stitch: "stitch_wire", bridle: "bridle",
};
/** Half of the gauge between rail centres, and the distance of the sleepers that are drawn, in m. */
const HALF_GAUGE = 0.75;
const SLEEPERS = 3;
/** Half of a collector head in m, as drawn: data of heads say less. */
const HALF_HEAD = 0.8;
/** Length of the arrow in m of a newton. */
const ARROW = 0.01;
const NEWTONS = 400;
/** Where the eye stands first, from the place it looks at, in m. */
const EYE = new Vector3(-16, 3, 13);
const KEY_TURN = 0.08; // rad
const KEY_ZOOM = 1.15;

type Colour = (name: string) => string;

/** Vertices that change from frame to frame. */
function changing(count: number): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
  return made;
}

const values = (of: BufferGeometry) => of.getAttribute("position").array as Float32Array;
const changed = (of: BufferGeometry) => void (of.getAttribute("position").needsUpdate = true);

export class Stage {
  readonly camera = new PerspectiveCamera(45, 2, 0.1, 2000);
  readonly controls: OrbitControls;
  section: Section | null = null;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly line = new Group();
  private readonly pantographs = new Group();
  private wires: Line[] = [];
  private taut = new LineSegments();
  private slack = new LineSegments();
  private arms = new LineSegments();
  private geometry: Geometry | null = null;
  private at = NaN;

  constructor(canvas: HTMLCanvasElement, private readonly colour: Colour, changedView: () => void) {
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true });
    this.scene.add(this.line, this.pantographs);
    this.camera.position.copy(EYE).add(new Vector3(0, 5, 0));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.set(0, 5, 0);
    this.controls.maxDistance = HALF;
    this.controls.addEventListener("change", changedView);
    this.controls.update();
  }

  size(width: number, height: number): void {
    // Software draws each pixel: more than those of the page would halve the frames.
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  /** The position along the track that is looked at. */
  get looked(): number {
    return this.controls.target.x + (this.section?.centre ?? 0);
  }

  private build(geometry: Geometry, x: number): void {
    this.clear();
    const before = this.section && this.geometry === geometry ? this.section.centre : x;
    this.geometry = geometry;
    const section = (this.section = sectionAround(geometry, x));
    // The world moves, the eye stays where it was along the track.
    this.camera.position.x += before - x;
    this.controls.target.x += before - x;
    this.wires = section.wires.map((part) => {
      const made = new BufferGeometry();
      made.setAttribute("position", new BufferAttribute(part.positions, 3));
      const kind = geometry.wires[part.wire]!.kind;
      return this.added(new Line(made, new LineBasicMaterial({ color: this.colour(COLOURS[kind]) })));
    });
    const count = 2 * section.droppers.length;
    this.taut = this.added(new LineSegments(changing(count), new LineBasicMaterial({ color: this.colour("dropper") })));
    const dashes = new LineDashedMaterial({ color: this.colour("slack"), dashSize: 0.08, gapSize: 0.08 });
    this.slack = this.added(new LineSegments(changing(count), dashes));
    this.arms = this.added(new LineSegments(changing(2 * section.arms.length), new LineBasicMaterial({ color: this.colour("arm") })));
    this.track(section);
  }

  private added<One extends Line>(one: One): One {
    one.frustumCulled = false; // its vertices change, its bounds are not kept
    this.line.add(one);
    return one;
  }

  private track(section: Section): void {
    const end = section.to - section.centre;
    const points: number[] = [];
    const first = Math.ceil(section.from / SLEEPERS) * SLEEPERS - section.centre;
    for (let x = first; x < end; x += SLEEPERS) {
      points.push(x, 0, -1.3, x, 0, 1.3);
      // In short pieces: software that draws lines drops those that begin far behind the eye.
      for (const z of [-HALF_GAUGE, HALF_GAUGE]) points.push(x, 0, z, x + SLEEPERS, 0, z);
    }
    // Masts are not in the data; a thin line says where a support is.
    for (const number of section.supports) {
      const { x_m, arms } = this.geometry!.supports[number]!;
      const z = -(arms[0]?.to[1] ?? 0);
      points.push(x_m - section.centre, 0, z, x_m - section.centre, arms[0]?.to[2] ?? 5, z);
    }
    const made = new BufferGeometry();
    made.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
    this.added(new LineSegments(made, new LineBasicMaterial({ color: this.colour("support") })));
  }

  /** Show a state; `follow`: the eye goes on with the first pantograph. */
  show(geometry: Geometry, state: MotionState, larger: number, follow: boolean): void {
    const x = state.pantographs[0]?.position ?? NaN;
    const there = Number.isFinite(x) ? x : (geometry.spans[0]?.start_m ?? 0);
    if (geometry !== this.geometry || !this.section) this.build(geometry, there);
    const wanted = follow ? there : this.looked;
    if (!holds(this.section!, geometry, wanted)) this.build(geometry, wanted);
    if (follow && Number.isFinite(this.at)) {
      this.camera.position.x += there - this.at;
      this.controls.target.x += there - this.at;
    }
    this.at = follow ? there : NaN;
    const section = this.section!;
    const { wires } = indexOf(geometry);
    section.wires.forEach((part, number) => {
      if (moveWire(part, wires[part.wire]!, state, larger)) changed(this.wires[number]!.geometry);
    });
    this.dropperEnds(section, state, larger);
    section.arms.forEach((arm, number) => writeSegment(values(this.arms.geometry), 6 * number, arm, section.centre, state, larger));
    changed(this.arms.geometry);
    this.heads(geometry, state, larger);
  }

  private dropperEnds(section: Section, state: MotionState, larger: number): void {
    let [taut, slack] = [0, 0];
    section.droppers.forEach((one, number) => {
      const loose = state.droppers[section.dropperNumbers[number]!] === 0;
      const out = loose ? this.slack : this.taut;
      writeSegment(values(out.geometry), 6 * (loose ? slack++ : taut++), one, section.centre, state, larger);
    });
    for (const [of, count] of [[this.taut, taut], [this.slack, slack]] as const) {
      of.geometry.setDrawRange(0, 2 * count);
      changed(of.geometry);
    }
    if (slack) this.slack.computeLineDistances();
  }

  private heads(geometry: Geometry, state: MotionState, larger: number): void {
    while (this.pantographs.children.length < state.pantographs.length) {
      this.pantographs.add(this.pantograph(this.pantographs.children.length));
    }
    state.pantographs.forEach((one, number) => {
      const group = this.pantographs.children[number] as Group;
      group.visible = Number.isFinite(one.position);
      // The head is at the wire as it is drawn: its rest, and the exaggerated uplift there.
      const rest = geometry.height_m;
      const height = Number.isFinite(one.height) ? rest + larger * (one.height - rest) : rest;
      group.position.set(one.position - this.section!.centre, height, 0);
      const [, frame, arrow] = group.children as [Mesh, LineSegments, Mesh];
      frame.scale.y = Math.max(0.5, height - 3.6);
      arrow.scale.y = Math.max(0.01, Math.min(one.force, NEWTONS) * ARROW);
      arrow.position.y = arrow.scale.y / 2;
    });
  }

  /** Head, frame and arrow of the force. */
  private pantograph(number: number): Group {
    const color = this.colour(colourOf(number));
    const made = new Group();
    const head = new Mesh(new BoxGeometry(0.4, 0.06, 2 * HALF_HEAD), new MeshBasicMaterial({ color }));
    head.position.y = -0.04;
    const joints = [0, 0, 0, 0.9, -0.5, 0, 0.9, -0.5, 0, 0, -1, 0, -1, -1, 0, 1, -1, 0];
    const frame = new BufferGeometry();
    frame.setAttribute("position", new BufferAttribute(Float32Array.from(joints), 3));
    const arrow = new Mesh(new BoxGeometry(0.07, 1, 0.07), new MeshBasicMaterial({ color }));
    made.add(head, new LineSegments(frame, new LineBasicMaterial({ color })), arrow);
    return made;
  }

  render(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** A point in px of the canvas; `null` where it is behind the eye. */
  project(x: number, y: number, z: number, width: number, height: number): [number, number] | null {
    const seen = new Vector3(x - (this.section?.centre ?? 0), y, z).project(this.camera);
    if (seen.z > 1) return null;
    return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height];
  }

  /** Turn about the place looked at by rad, or come nearer. */
  turn(around: number, up: number, nearer = 1): void {
    const away = this.camera.position.clone().sub(this.controls.target);
    away.applyAxisAngle(new Vector3(0, 1, 0), around);
    const side = new Vector3(0, 1, 0).cross(away).normalize();
    away.applyAxisAngle(side, up).multiplyScalar(1 / nearer);
    this.camera.position.copy(this.controls.target).add(away);
    this.controls.update();
  }

  /** A key of the view; false where it means nothing here. */
  key(event: KeyboardEvent): boolean {
    const turns: Record<string, () => void> = {
      ArrowLeft: () => this.turn(-KEY_TURN, 0),
      ArrowRight: () => this.turn(KEY_TURN, 0),
      ArrowUp: () => this.turn(0, -KEY_TURN),
      ArrowDown: () => this.turn(0, KEY_TURN),
      "+": () => this.turn(0, 0, KEY_ZOOM),
      "-": () => this.turn(0, 0, 1 / KEY_ZOOM),
    };
    if (event.shiftKey && event.key.startsWith("Arrow")) return this.pan(event.key);
    turns[event.key]?.();
    return event.key in turns;
  }

  private pan(key: string): boolean {
    const step = this.camera.position.distanceTo(this.controls.target) / 10;
    const along = { ArrowLeft: -step, ArrowRight: step }[key] ?? 0;
    const up = { ArrowUp: step, ArrowDown: -step }[key] ?? 0;
    for (const one of [this.camera.position, this.controls.target]) one.add(new Vector3(along, up, 0));
    this.controls.update();
    return true;
  }

  private clear(): void {
    for (const one of [...this.line.children, ...this.pantographs.children.flatMap((group) => group.children)]) {
      (one as Mesh).geometry.dispose();
      ((one as Mesh).material as Material).dispose();
    }
    this.line.clear();
    this.pantographs.clear();
  }

  close(): void {
    this.clear();
    this.controls.dispose();
    this.renderer.dispose();
  }
}
