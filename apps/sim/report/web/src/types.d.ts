// What a study is made of: docs/study-format.md says what each part means, study.schema.json holds it.
export type Vector = [number, number, number];

export interface Point {
  id: number;
  method: string;
  library?: string | null;
  formulation?: string | null;
  code?: string | null;
  number?: string | null;
  projection?: string | null;
  engine?: string | null;
  tolerance?: number | null;
  step?: number | null;
  status: 'ok' | 'failed' | 'refused';
  why?: string | null;
  error: number | null;
  worst_output?: string | null;
  time_s: number | null;
  time_min_s?: number | null;
  time_max_s?: number | null;
  repeats?: number | null;
  calls?: number | null;
  steps?: number | null;
  rejected?: number | null;
  drift?: Record<string, number | null> | null;
  pareto?: boolean;
  is_default?: boolean;
}

export interface Drift {
  point: number;
  t: (number | null)[];
  [invariant: string]: any;
}

export interface Lanes {
  number: string;
  lanes: number;
  threads: number;
  trajectories?: number | null;
  trajectories_per_s: number | null;
  ratio: number | null;
}

export interface Build {
  formulation: string;
  number: string;
  generate_s: number | null;
  compile_s: number | null;
  operations?: number | null;
}

export interface Shape {
  kind: 'sphere' | 'box' | 'cylinder' | 'point' | 'none';
  radius?: number;
  length?: number;
  size?: Vector;
  see_through?: boolean;
}

export interface Body {
  name: string;
  shape?: Shape;
  position: (Vector | null)[];
  orientation?: ([number, number, number, number] | null)[] | null;
}

export interface Rod {
  name: string;
  points: (Vector[] | null)[];
}

export interface Reaction {
  name: string;
  body?: string | null;
  at: (Vector | null)[];
  force: (Vector | null)[];
  unit?: string | null;
}

export interface Motion {
  up?: Vector;
  t: number[];
  bodies?: Body[];
  lines?: Rod[];
  reactions?: Reaction[];
}

/** A scene with some of its effects. */
export interface EffectSet {
  what?: string;
  effects: string[];
  why?: string | null;
  operations?: number | null;
  ns?: number | null;
  run_seconds?: number | null;
  calls?: number | null;
  change?: number | null;
  output?: string | null;
  lacks?: string[];
}

export interface Effects {
  why?: string | null;
  scene?: string;
  duration?: number | null;
  method?: string;
  engine?: string;
  good_to?: number | null;
  about?: Record<string, string>;
  all?: EffectSet;
  none?: EffectSet;
  shared_operations?: number | null;
  each?: EffectSet[];
  ladder?: EffectSet[];
  need?: {change: number, chosen?: EffectSet};
}

export interface Reference {
  kind: string;
  methods?: string[];
  agreement?: number | null;
}

export interface Problem {
  name: string;
  about?: string;
  file?: string;
  scene?: string;
  why?: string;
  duration?: number | null;
  samples?: number | null;
  outputs?: {name: string, unit?: string | null, range?: number | null, scale?: number | null}[];
  reference?: Reference | null;
  builds?: Build[];
  points?: Point[];
  drifts?: Drift[];
  lanes?: Lanes[];
  motion?: Motion | null;
  effects?: Effects | null;
}

export interface Study {
  format: number;
  tool?: string;
  machine?: {processor?: string, cores?: number, system?: string, compiler?: string, flags?: string} | null;
  budget_s?: number | null;
  interrupted?: boolean;
  problems?: Problem[];
}

/** A problem with every list in place, so that charts need not ask. */
export type FullProblem = Problem & Required<Pick<Problem, 'outputs' | 'builds' | 'points' | 'drifts' | 'lanes'>>;

/** How charts look: colours of the theme, and how methods and number types are told apart. */
export interface Look {
  ink: string;
  muted: string;
  grid: string;
  surface: string;
  accent: string;
  fault: string;
  band: string;
  colours: string[];
  /** Names of methods and number types of the whole study: a method keeps its colour in every chart. */
  methods: string[];
  numbers: string[];
  /** Of a static picture: title and legend are inside. */
  still: boolean;
}

export interface Column {
  key: string;
  title: string;
  /** How a value is written; text as it is if none. */
  format?: (value: any) => string;
  /** Numbers are set flush right, and sorted as numbers. */
  numeric?: boolean;
}

export interface Table {
  caption: string;
  columns: Column[];
  rows: Record<string, any>[];
}

/** One place of a chart that can be pointed at: what it says, and where it is. */
export interface Spot {
  series: number;
  index: number;
  detail: () => [string, string][];
}

export interface Picture {
  option: any;
  takeaway: string;
  note?: string;
  table: Table;
  spots: Spot[];
  /** In pixels; a function of the width where that decides what stands below what. */
  height?: number | ((width: number) => number);
  /** Where more can be drawn: how many of how many are. */
  more?: {drawn: number, all: number, word: string};
  /** What can be placed only where the size is known. */
  arrange?: (chart: import('echarts/core').EChartsType, option: any) => void;
  /** What symbols and dashes mean. */
  key?: {methods: string[], numbers: string[], extra?: KeyEntry[]};
}

export interface KeyEntry {
  label: string;
  colour?: string;
  symbol?: string;
  fill?: string;
  dash?: string | number[];
}

export interface Chart {
  id: string;
  title: string;
  short: string;
  about: string;
  /** A picture, or a sentence that says why there is none; `all`: with what is left out at first. */
  make: (problem: FullProblem, points: Point[], look: Look, all?: boolean) => Picture | string;
}
