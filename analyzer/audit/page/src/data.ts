// What the data of the page look like. They are written by analyzer/audit/page.cc: gzip of JSON, in base64, in elements that
// browsers do not run. The index is read at once, the parts when one of their programs is opened.

export interface Run {
  id: number; started: string; seconds: number; version: string;
  files: number; checked: number; errors: number; warnings: number; infos: number; new: number; gone: number;
}

export interface Rule { code: string; name: string; summary: string; markdown: string }

/** Files are programs of the run, or something else with findings: the INIs of machines, and subs from outside of the audited folders. */
export const program = 0, machine = 1;

/**
 * Columns of equal length. Severities: 0 info, 1 warning, 2 error. Fixes: 0 none, 1 one to look at first, 2 a safe one. Paths are
 * seen from the audited folders; `…/` stands before those of files from elsewhere.
 */
export interface Index {
  schema: string;
  tool: { name: string; version: string };
  made: string;
  roots: string[];
  runs: Run[];
  rules: Rule[];
  files: { path: string[]; kind: number[]; lines: number[]; bytes: number[]; part: number[]; problem: string[] };
  findings: { file: number[]; rule: number[]; severity: number[]; line: number[]; column: number[]; message: string[]; fix: number[]; isNew: number[] };
  gone: { path: string[]; rule: number[]; severity: number[]; line: number[]; message: string[] };
  calls: { from: number[]; to: number[] };
}

export interface Position { line: number; column: number; offset: number }
/** `file`: its number, -1 for one that this page does not have. */
export interface Related { file: number; path: string; message: string; start: Position; end: Position }
export interface Edit { start: Position; end: Position; text: string }
export interface Fix { title: string; safe: boolean; edits: Edit[] }

/** `arc`: of an arc that does not fit, what its drawing says, and an SVG. As `owlint check --format json` has the rest. From `pathFrom` on, the related places say why a run gets to the finding, or why none does. */
export interface Finding {
  code: string; rule: string; severity: string; message: string; start: Position; end: Position;
  reach: string; stops: boolean; interpreter?: string; help?: string; related: Related[]; pathFrom: number;
  fixes: Fix[];
  arc?: { words: string; drawing: string };
}

/** The subs of a program with what is in them. Blocks come after the blocks that they are in; `to` is null where a call leads nowhere. */
export interface Blocks {
  scopes: { title: string; line: number; end: number | null }[];
  blocks: { title: string; line: number; end: number | null; scope: number; parent: number | null; parts: { title: string; line: number }[] }[];
  calls: { title: string; line: number; scope: number; to: { file: number; line: number } | null }[];
}

/** `file`: its number, -1 for one that this page does not have. */
export interface LineOf { file: number; line: number }
export interface Range { least: number; greatest: number }

/** How far a program goes: as `owlint extents --format json` has it. */
export interface Extents {
  unit: string;
  origins: { system: string | null; g92: boolean; from_start: boolean; axes: Record<string, Range & { least_at: LineOf; greatest_at: LineOf; rapid: Range | null; feed: Range | null }> }[];
  complete: boolean;
  unknown: (LineOf & { axes: string[]; why: string })[];
  stops_at: LineOf | null;
}
/** A line of the program itself, or of another file, -1 for one that this page does not have. */
export type Place = number | [file: number, line: number, name: string];
/**
 * Names of modes, each with 1 if lines tell of its changes. A step is what is in effect from a shown line on, if that is not what
 * was in effect on the one above: the number of a name, the value, and where it was set; null where no run gets.
 */
export interface Modes { names: [string, number][]; steps: [number, [number, string, Place[]][] | null][] }

export interface Details {
  lineCount: number;
  /** Stretches of lines: the number of the first, and their texts. */
  source: [number, string[]][];
  findings: Finding[];
  modes: Modes | null;
  blocks: Blocks | null;
  extents: Extents | null;
}

async function unpacked(id: string): Promise<string> {
  const element = document.getElementById(id);
  if (!element) throw new Error(`this page has no ${id}`);
  const bytes = Uint8Array.from(atob(element.textContent!.replace(/\s+/g, "")), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).text();
}

export async function readIndex(): Promise<Index> {
  return JSON.parse(await unpacked("owlint-index"));
}

const parts = new Map<number, Promise<Record<string, Details>>>();

/** What is known of a program beyond the index; null where the page does not hold it. */
export async function readDetails(index: Index, file: number): Promise<Details | null> {
  const part = index.files.part[file];
  if (part === undefined || part < 0) return null;
  if (!parts.has(part)) {
    if (parts.size > 20) parts.delete(parts.keys().next().value!);
    parts.set(part, unpacked(`owlint-part-${part}`).then((text) => JSON.parse(text)));
  }
  return (await parts.get(part)!)[file] ?? null;
}

export { unpacked };
