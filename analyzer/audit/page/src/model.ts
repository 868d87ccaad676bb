// Questions to the index: which findings a program has, what lies in which folder, who calls whom.
import type { Index } from "./data";

export const severities = ["info", "warning", "error"] as const;
export const signs = ["i", "!", "✕"] as const;

export interface FolderRow { path: string; errors: number; warnings: number; programs: number }

export class Model {
  readonly shown: string[];              // paths, seen from the folder that all have in common
  readonly common: string;
  readonly firstFinding: Int32Array;     // by file: its findings are [firstFinding[f], firstFinding[f + 1])
  readonly counts: Uint32Array[];        // by severity and file
  private calledBy?: Map<number, number[]>;
  private callsOf?: Map<number, number[]>;
  private byShown?: Map<string, number>;

  constructor(readonly index: Index) {
    const paths = index.files.path;
    this.common = commonFolder(paths);
    this.shown = paths.map((path) => path.slice(this.common.length));
    const { file, severity } = index.findings;
    this.firstFinding = new Int32Array(paths.length + 1);
    this.counts = severities.map(() => new Uint32Array(paths.length));
    for (let i = 0; i < file.length; ++i) {
      ++this.firstFinding[file[i] + 1];
      ++this.counts[severity[i]][file[i]];
    }
    for (let f = 0; f < paths.length; ++f) this.firstFinding[f + 1] += this.firstFinding[f];
  }

  get run() { return this.index.runs[this.index.runs.length - 1]; }
  get before() { return this.index.runs[this.index.runs.length - 2]; }

  fileOf(path: string): number | undefined {
    this.byShown ??= new Map(this.index.files.path.map((p, i) => [p, i]));
    return this.byShown.get(path);
  }

  calls(file: number): number[] {
    this.callsOf ??= grouped(this.index.calls.from, this.index.calls.to);
    return this.callsOf.get(file) ?? [];
  }

  callers(file: number): number[] {
    this.calledBy ??= grouped(this.index.calls.to, this.index.calls.from);
    return this.calledBy.get(file) ?? [];
  }

  /** How many findings each rule has: errors, warnings, infos; most errors first. */
  byRule(): { rule: number; counts: number[] }[] {
    const rows = this.index.rules.map((_, rule) => ({ rule, counts: [0, 0, 0] }));
    const { rule, severity } = this.index.findings;
    for (let i = 0; i < rule.length; ++i) ++rows[rule[i]].counts[severity[i]];
    return rows.filter((row) => row.counts.some((n) => n > 0)).sort((a, b) => b.counts[2] - a.counts[2] || b.counts[1] - a.counts[1] || b.counts[0] - a.counts[0]);
  }

  /** The folders right below one, with what is in them; programs of its own as ".". */
  folders(below: string): FolderRow[] {
    const rows = new Map<string, FolderRow>();
    for (let f = 0; f < this.shown.length; ++f) {
      const path = this.shown[f];
      if (!path.startsWith(below)) continue;
      const slash = path.indexOf("/", below.length);
      const key = slash < 0 ? "" : path.slice(0, slash + 1);
      let row = rows.get(key);
      if (!row) rows.set(key, (row = { path: key, errors: 0, warnings: 0, programs: 0 }));
      ++row.programs;
      row.errors += this.counts[2][f];
      row.warnings += this.counts[1][f];
    }
    return [...rows.values()].sort((a, b) => b.errors - a.errors || b.warnings - a.warnings || (a.path < b.path ? -1 : 1));
  }
}

function grouped(keys: number[], values: number[]): Map<number, number[]> {
  const out = new Map<number, number[]>();
  keys.forEach((key, i) => out.get(key)?.push(values[i]) ?? out.set(key, [values[i]]));
  return out;
}

/** With its slash; empty where there is none. */
function commonFolder(paths: string[]): string {
  if (paths.length === 0) return "";
  let common = paths[0].slice(0, paths[0].lastIndexOf("/") + 1);
  for (const path of paths) {
    while (!path.startsWith(common)) common = common.slice(0, common.lastIndexOf("/", common.length - 2) + 1);
  }
  return common;
}

export const number = (n: number) => n.toLocaleString("en");
export const plural = (n: number, word: string) => `${number(n)} ${word}${n === 1 ? "" : "s"}`;
