// Colours for code: the grammars say what each piece of a line is, and a few classes are made of that. For programs it is the
// grammar of the VS Code extension. No construct of either goes on over the end of a line.
import { createJavaScriptRegexEngine } from "@shikijs/engine-javascript";
import { INITIAL, Registry, type IGrammar, type IRawGrammar } from "@shikijs/vscode-textmate";
import programs from "../../../../editors/vscode/syntaxes/linuxcnc.tmLanguage.json";
import machines from "./ini.tmLanguage.json";

export type Language = "program" | "machine";
export interface Piece { text: string; kind: string }

// By the beginning of a scope's name; the innermost scope that has one decides.
const kinds: [string, string][] = [
  ["comment", "comment"], ["string.other.active-comment", "comment"],
  ["entity.name.section", "oword"], ["entity.name", "oword"], ["keyword.control", "keyword"], ["keyword.other.g-code", "word"], ["keyword.other.m-code", "word"],
  ["keyword.operator.comparison", "keyword"], ["keyword.operator.logical", "keyword"], ["support.function", "keyword"],
  ["variable", "parameter"], ["constant.numeric", "number"], ["invalid", "comment"],
];

const grammars = new Map<Language, IGrammar>();

function grammarOf(language: Language): IGrammar {
  let grammar = grammars.get(language);
  if (!grammar) {
    const engine = createJavaScriptRegexEngine();
    const raw = (language === "program" ? programs : machines) as unknown as IRawGrammar;
    const registry = new Registry({
      onigLib: { createOnigScanner: engine.createScanner, createOnigString: engine.createString },
      loadGrammar: () => raw,
      theme: { settings: [] },
    });
    grammars.set(language, (grammar = registry.loadGrammar(raw.scopeName)!));
  }
  return grammar;
}

function kindOf(scopes: string[]): string {
  for (const scope of [...scopes].reverse()) {
    const known = kinds.find(([start]) => scope.startsWith(start));
    if (known) return known[1];
  }
  return "";
}

/** The pieces of a line; together they are the line. */
export function pieces(line: string, language: Language): Piece[] {
  const slowest = 500;  // ms: a line made to take longer has no colours at its end
  const out: Piece[] = [];
  for (const { startIndex, endIndex, scopes } of grammarOf(language).tokenizeLine(line, INITIAL, slowest).tokens) {
    const text = line.slice(startIndex, endIndex);
    const kind = kindOf(scopes);
    if (out.length > 0 && out[out.length - 1].kind === kind) out[out.length - 1].text += text;
    else if (text !== "") out.push({ text, kind });
  }
  const done = out.reduce((n, piece) => n + piece.text.length, 0);
  if (done < line.length) out.push({ text: line.slice(done), kind: "" });
  return out;
}
