// What the data of the page look like. They are written by analyzer/audit/page.cc: gzip of JSON, in base64, in elements that
// browsers do not run. The index is read at once, the parts when one of their programs is opened.

export interface Run {
  id: number; started: string; seconds: number; version: string;
  files: number; checked: number; errors: number; warnings: number; infos: number; new: number; gone: number;
}

export interface Rule { code: string; name: string; summary: string; markdown: string }

/** Columns of equal length. Severities: 0 info, 1 warning, 2 error. */
export interface Index {
  schema: string;
  tool: { name: string; version: string };
  made: string;
  roots: string[];
  runs: Run[];
  rules: Rule[];
  files: { path: string[]; lines: number[]; bytes: number[]; part: number[]; problem: string[] };
  findings: { file: number[]; rule: number[]; severity: number[]; line: number[]; column: number[]; message: string[]; isNew: number[] };
  gone: { path: string[]; rule: number[]; severity: number[]; line: number[]; message: string[] };
  calls: { from: number[]; to: number[] };
}

export interface Position { line: number; column: number; offset: number }
export interface Related { path: string; message: string; start: Position; end: Position }

/** As `owlint --format json` has it. */
export interface Finding {
  code: string; rule: string; severity: string; message: string; start: Position; end: Position;
  reach: string; stops: boolean; interpreter?: string; help?: string; related: Related[];
  fixes: { title: string; safe: boolean }[];
}

export interface Details {
  lineCount: number;
  /** Stretches of lines: the number of the first, and their texts. */
  source: [number, string[]][];
  findings: Finding[];
  /** DOT; node classes say `line-12`, `file-3`, `error`. */
  graph: string | null;
  graphFiles: string[];
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
