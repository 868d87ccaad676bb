// Questions to the index: which findings a program has, what lies in which folder, who calls whom.
import type { Index } from "./data";
import { program } from "./data";

export const severities = ["info", "warning", "error"] as const;
export const signs = ["i", "!", "✕"] as const;

export interface FolderRow { path: string; errors: number; warnings: number; programs: number }

export class Model {
  readonly paths: string[];
  readonly programs: number;             // INIs and subs from elsewhere are no programs of the audit
  readonly counts: Uint32Array[];        // by severity and file
  private calledBy?: Map<number, number[]>;
  private callsOf?: Map<number, number[]>;

  constructor(readonly index: Index) {
    this.paths = index.files.path;
    this.programs = index.files.kind.reduce((n, kind) => n + (kind === program ? 1 : 0), 0);
    this.counts = severities.map(() => new Uint32Array(this.paths.length));
    const { file, severity } = index.findings;
    for (let i = 0; i < file.length; ++i) ++this.counts[severity[i]][file[i]];
  }

  get run() { return this.index.runs[this.index.runs.length - 1]; }
  get before() { return this.index.runs[this.index.runs.length - 2]; }

  isProgram(file: number): boolean {
    return this.index.files.kind[file] === program;
  }

  calls(file: number): number[] {
    this.callsOf ??= grouped(this.index.calls.from, this.index.calls.to);
    return this.callsOf.get(file) ?? [];
  }

  callers(file: number): number[] {
    this.calledBy ??= grouped(this.index.calls.to, this.index.calls.from);
    return this.calledBy.get(file) ?? [];
  }

  /** Findings, the worst first; of equal ones as they come in the index, by path and line. */
  worstFirst(findings: number[]): number[] {
    const { severity } = this.index.findings;
    return findings.sort((a, b) => severity[b] - severity[a] || a - b);
  }

  /** How many findings each rule has: infos, warnings, errors; most errors first. */
  byRule(): { rule: number; counts: number[] }[] {
    const rows = this.index.rules.map((_, rule) => ({ rule, counts: [0, 0, 0] }));
    const { rule, severity } = this.index.findings;
    for (let i = 0; i < rule.length; ++i) ++rows[rule[i]].counts[severity[i]];
    return rows.filter((row) => row.counts.some((n) => n > 0)).sort((a, b) => b.counts[2] - a.counts[2] || b.counts[1] - a.counts[1] || b.counts[0] - a.counts[0]);
  }

  /** The folders right below one, with what is in them; the files right there are the row without a path. */
  folders(below: string): FolderRow[] {
    const rows = new Map<string, FolderRow>();
    for (let f = 0; f < this.paths.length; ++f) {
      const path = this.paths[f];
      if (!path.startsWith(below)) continue;
      const slash = path.indexOf("/", below.length);
      const key = slash < 0 ? "" : path.slice(0, slash + 1);
      let row = rows.get(key);
      if (!row) rows.set(key, (row = { path: key, errors: 0, warnings: 0, programs: 0 }));
      if (this.isProgram(f)) ++row.programs;
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

export const number = (n: number) => n.toLocaleString("en");
export const plural = (n: number, word: string) => `${number(n)} ${word}${n === 1 ? "" : "s"}`;
/** `892 programs`, or `12 of 892 programs`. */
export const share = (n: number, all: number, word: string) => (n === all ? plural(all, word) : `${number(n)} of ${plural(all, word)}`);
