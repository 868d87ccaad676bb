// What a piece of a program is coloured as, and what counts as a word: `npm test`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { test } from "node:test";
import oniguruma from "vscode-oniguruma";
import textmate from "vscode-textmate";

const file = (path) => new URL(`../${path}`, import.meta.url);
const wasm = createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm");
await oniguruma.loadWASM(await readFile(wasm));
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => textmate.parseRawGrammar(await readFile(file("syntaxes/linuxcnc.tmLanguage.json"), "utf8"), "linuxcnc.json"),
});
const grammar = await registry.loadGrammar("source.linuxcnc");
// VS Code allows comments in this file; JSON does not.
const language = JSON.parse((await readFile(file("language-configuration.json"), "utf8")).replace(/^\s*\/\/.*$/gm, ""));

/** A line as [text, innermost scope without `.linuxcnc`], neighbours of one scope together, without what has none of its own. */
function pieces(line) {
  const found = [];
  for (const { startIndex, endIndex, scopes } of grammar.tokenizeLine(line, textmate.INITIAL).tokens) {
    const scope = scopes.at(-1).replace(/\.linuxcnc$/, "");
    const text = line.slice(startIndex, endIndex);
    if (found.at(-1)?.[1] === scope) found.at(-1)[0] += text;
    else found.push([text, scope]);
  }
  return found
    .map(([text, scope]) => [text.trim(), scope])
    .filter(([text, scope]) => text !== "" && !/^(source|meta|punctuation)/.test(scope));
}

const lines = {
  "o100 while [#1 LT 5]": [
    ["o100", "entity.name.type.label"], ["while", "keyword.control.block"],
    ["#1", "variable.parameter"], ["LT", "keyword.operator.comparison"], ["5", "constant.numeric"],
  ],
  "N20 O<drill> CALL [#<depth>] [#<_safe>]": [
    ["N20", "constant.other.line-number"], ["O<drill>", "entity.name.function"],
    ["CALL", "keyword.control.sub"], ["#<depth>", "variable.other.local"], ["#<_safe>", "variable.other.global"],
  ],
  "o100sub": [["o100", "entity.name.function"], ["sub", "keyword.control.sub"]],
  "o<a>elseif[1]": [
    ["o<a>", "entity.name.type.label"], ["elseif", "keyword.control.block"], ["1", "constant.numeric"],
  ],
  "o[#1+2] endif": [
    ["o", "entity.name.type.label"], ["#1", "variable.parameter"], ["+", "keyword.operator.arithmetic"], ["2", "constant.numeric"],
    ["endif", "keyword.control.block"],
  ],
  "O1234 (PLATE)": [
    ["O1234", "entity.name.type.label"], ["(PLATE)", "comment.block.parentheses"],
  ],
  "G1 X-2.5 Y#31 F[300 MOD 7]": [
    ["G1", "keyword.other.g-code"], ["X", "storage.type.axis"], ["-2.5", "constant.numeric"], ["Y", "storage.type.axis"],
    ["#31", "variable.other.global"], ["F", "entity.other.attribute-name.word"], ["300", "constant.numeric"],
    ["MOD", "keyword.operator.arithmetic"], ["7", "constant.numeric"],
  ],
  "/ m30 ; the (end)": [
    ["/", "keyword.other.block-delete"], ["m30", "keyword.other.m-code"], ["; the (end)", "comment.line.semicolon"],
  ],
  "#<x>=sqrt[#2**2]": [
    ["#<x>", "variable.other.local"], ["=", "keyword.operator.assignment"], ["sqrt", "support.function"],
    ["#2", "variable.parameter"], ["**", "keyword.operator.arithmetic"], ["2", "constant.numeric"],
  ],
  "(a (b) g1": [
    ["(a", "comment.block.parentheses"], ["(", "invalid.illegal.nested-comment"], ["b)", "comment.block.parentheses"],
    ["g1", "keyword.other.g-code"],
  ],
  "(debug, z #<z>)": [
    ["(", "string.other.active-comment"], ["debug", "keyword.other.active-comment"], [", z", "string.other.active-comment"],
    ["#<z>", "variable.other.local"], [")", "string.other.active-comment"],
  ],
  "(owlint: ignore OW104 -- never both)": [
    ["(", "comment.suppression"], ["owlint", "keyword.other.suppression"], [":", "comment.suppression"],
    ["ignore", "keyword.other.suppression"], ["OW104", "constant.other.code"], ["-- never both)", "comment.suppression"],
  ],
  "%": [["%", "keyword.control.tape"]],
};

for (const [line, expected] of Object.entries(lines)) {
  test(`colours of ${line}`, () => assert.deepEqual(pieces(line), expected));
}

test("a comment that is not closed ends with its line", () => {
  const { ruleStack } = grammar.tokenizeLine("(open", textmate.INITIAL);
  assert.equal(grammar.tokenizeLine("g1", ruleStack).tokens[0].scopes.at(-1), "keyword.other.g-code.linuxcnc");
});

test("labels and parameters are words", () => {
  const { pattern, flags } = language.wordPattern;
  const words = (line) => line.match(new RegExp(pattern, `g${flags}`));
  assert.deepEqual(words("o<drill hole> call [#<depth>] [##12]"), ["o<drill hole>", "call", "#<depth>", "##12"]);
  assert.deepEqual(words("o100 if [#<dep"), ["o100", "if", "#<dep"]);
});

test("blocks are indented", () => {
  const { increaseIndentPattern: more, decreaseIndentPattern: less } = language.indentationRules;
  const matches = (rule, line) => new RegExp(rule.pattern, rule.flags).test(line);
  assert.ok(["o100 sub", "N10 O<a> IF [1]", "o[#1] else", "o1 repeat [2]"].every((line) => matches(more, line)));
  assert.ok(["o100 endsub", "N10 O<a> ELSEIF [1]", "/ o1 endif"].every((line) => matches(less, line)));
  assert.ok(!["o100 call", "o100 endif", "o1 break", "g1 (o1 if)"].some((line) => matches(more, line)));
});
