// Help while writing: completion, signatures, hints, hover, colours.
import assert from 'node:assert/strict';
import { markup, session } from './client.mjs';
import { offered } from './offered.mjs';
import * as places from './places.mjs';
import { files } from './shop.mjs';

const main = 'main.ngc';

const starts = (items, line) => items.some((item) => item.line.startsWith(line));

session('completion: keywords that fit behind a label', {}, async (client) => {
  const parts = await offered(client, 'G21 G90\no110 if [#5070 EQ 0]\n  G0 X1\no110 e‸\nM2\n');
  for (const line of ['o110 else', 'o110 elseif', 'o110 endif']) assert.ok(starts(parts, line), `${line} in ${parts.map((one) => one.line)}`);
  assert.ok(parts.every((item) => !/endwhile|endrepeat|endsub/.test(item.line)));
  const inLoop = await offered(client, 'G21 G90\no120 while [#5070 EQ 0]\n  G0 X1\n  o120 ‸\nM2\n');
  for (const line of ['  o120 break', '  o120 continue', '  o120 endwhile']) assert.ok(starts(inLoop, line), line);
  assert.ok(!starts(inLoop, '  o120 else'));
  const unknown = await offered(client, 'G21 G90\no130 ‸\nM2\n');
  for (const line of ['o130 if', 'o130 while', 'o130 repeat', 'o130 do', 'o130 sub', 'o130 call']) assert.ok(starts(unknown, line), line);
  assert.ok(!starts(unknown, 'o130 endif'));
  const inSub = await offered(client, 'o<bore> sub\n  G0 X1\n  o<bore> ‸\n');
  for (const line of ['  o<bore> endsub', '  o<bore> return']) assert.ok(starts(inSub, line), line);
});

session('completion: the end of the innermost block', {}, async (client) => {
  const text = 'G21 G90\no100 while [#5070 EQ 0]\n  o110 if [#5420 GT 5]\n    G0 X1\n  ‸\nM2\n';
  const lines = (await offered(client, text)).map((item) => item.line);
  const inner = lines.indexOf('  o110 endif');
  assert.ok(inner >= 0, `${lines}`);
  const outer = lines.findIndex((line) => line.includes('endwhile'));
  assert.ok(outer < 0 || inner < outer, 'the inner block first');
  assert.ok(starts(await offered(client, text.replace('‸', 'o‸')), '  o110 endif'));
  const closed = await offered(client, 'G21 G90\no110 if [1]\no110 endif\n‸\nM2\n');
  assert.ok(closed.every((item) => !item.line.includes('endif')), 'no block is open');
});

session('completion: subs that are known', { files }, async (client) => {
  const items = await offered(client, 'o<own> sub\no<own> endsub\no<‸\nM2\n');
  const face = items.find((item) => item.line.startsWith('o<face>'));
  assert.match(`${face.detail} ${face.labelDetails?.description}`, /face\.ngc/);
  assert.ok(starts(items, 'o<both>'), 'of another file');
  assert.ok(starts(items, 'o<own>'), 'of the program itself');
  const closed = await offered(client, 'G21 G90\no<fa‸> call [1]\nM2\n');
  assert.ok(closed.some((item) => /^o<face>/.test(item.line)));
  assert.ok(closed.every((item) => !item.line.includes('>>') && !/call.*call/.test(item.line)), `${closed.map((one) => one.line)}`);
});

session('completion: a file is offered only if it has the sub', { files: { ...files, 'plate.ngc': 'G21 G90\nG0 X1\nM2\n' } }, async (client) => {
  const items = await offered(client, 'o<‸\nM2\n');
  assert.ok(starts(items, 'o<face>'));
  assert.ok(!starts(items, 'o<plate>'), 'a program, which a call of it would run to its end');
});

session('completion: a number that is free', {}, async (client) => {
  const text = 'G21 G90\no100 if [1]\no100 endif\no110 if [1]\no110 endif\n‸\nM2\n';
  for (const draft of [text, text.replace('‸', 'o‸')]) {
    const numbers = (await offered(client, draft)).map((item) => /^o(\d+)/.exec(item.line)?.[1]).filter(Boolean);
    assert.ok(numbers.length > 0);
    for (const number of numbers) assert.ok(!['100', '110'].includes(number), `o${number} is used`);
  }
});

session('completion offers nothing in comments and on lines of motion', { files }, async (client) => {
  assert.deepEqual(await offered(client, 'G21 G90\n(o110 ‸)\nM2\n'), []);
  assert.deepEqual(await offered(client, 'G21 G90\nG0 X1 ‸\nM2\n'), []);
});

session('signatureHelp in the arguments of a call', { files }, async (client) => {
  client.open(main);
  const help = (piece, into) => client.request('textDocument/signatureHelp', client.params(main, piece, into));
  for (const [piece, active] of [['[30]', 0], ['[40]', 1]]) {
    const result = await help(piece, 1);
    const signature = result.signatures[result.activeSignature ?? 0];
    assert.match(signature.label, /face/);
    assert.equal(signature.parameters.length, 2);
    assert.equal(signature.activeParameter ?? result.activeParameter, active);
    for (const { label } of signature.parameters) assert.ok(typeof label === 'string' ? signature.label.includes(label) : label[1] <= signature.label.length);
  }
  const drill = await help('[10]', 1);
  assert.equal(drill.signatures[0].parameters.length, 1);
  assert.equal((await help('G21', 1)) ?? null, null);
  client.replace(main, ['call [20]', 'call [20] [']); // as it is being written
  assert.equal((await help('call [20] [', 11)).activeParameter, 1);
});

/** Hints by line: the text of their labels. */
async function hints(client, range) {
  const all = await client.request('textDocument/inlayHint', client.document(main, { range }));
  return all.map((one) => ({ ...one, text: typeof one.label === 'string' ? one.label : one.label.map((part) => part.value).join('') }));
}

session('inlayHint: arguments, and what an end belongs to', { files }, async (client) => {
  client.open(main);
  const all = await hints(client, { start: { line: 0, character: 0 }, end: { line: 21, character: 0 } });
  const call = all.filter((one) => one.position.line === 13);
  assert.equal(call.length, 2);
  for (const [i, piece] of ['[30]', '[40]'].entries()) {
    const { character } = client.at(main, piece);
    assert.ok([character, character + 1].includes(call[i].position.character));
    assert.match(call[i].text, [/#1|width/, /#2|length/][i]);
  }
  const [sub, ...others] = all.filter((one) => one.position.line === 1);
  assert.deepEqual(others, []);
  assert.match(sub.text, /^reads #1; returns no value$/);
  for (const [line, condition] of [[18, '#5420 GT 5'], [19, '#5070 EQ 0'], [7, '3'], [6, '#1 LT 0']]) {
    const [hint, ...more] = all.filter((one) => one.position.line === line);
    assert.deepEqual(more, []);
    assert.ok(hint.text.includes(condition), `${hint.text} on line ${line}`);
    assert.equal(hint.position.character, files[main].split('\n')[line].length, 'behind the keyword');
  }
  const some = await hints(client, { start: { line: 12, character: 0 }, end: { line: 16, character: 0 } });
  assert.deepEqual(some.map((one) => one.position.line), [13, 13]);
});

session('hover', { files }, async (client) => {
  client.open(main);
  const hover = async (piece, into) => {
    const place = client.params(main, piece, into);
    const result = await client.request('textDocument/hover', place);
    if (result?.range) assert.ok(places.contains(result.range, { start: place.position, end: place.position }), piece);
    return result && markup(result.contents);
  };
  assert.match(await hover('o120 elseif', 7), /elseif/);
  const loop = await hover('o100 break', 2);
  assert.match(loop, /break/);
  assert.match(loop, /o100 while/);
  assert.match(loop, /line 12\b/);
  assert.match(loop, /line 20\b/);
  const face = await hover('o<face> call', 4);
  assert.match(face, /faces one blank/);
  assert.match(face, /face\.ngc/);
  const drill = await hover('o<drill> call [10]', 4);
  assert.match(drill, /drills, and faces where the blank is thick/);
  assert.match(drill, /line 2\b/);
  assert.match(drill, /It reads #1; returns no value\./);
});

/** Tokens as they lie in the text. */
function decoded(client, text, data) {
  const { tokenTypes, tokenModifiers } = client.capabilities.semanticTokensProvider.legend;
  assert.equal(data.length % 5, 0);
  const rows = text.split('\n');
  const tokens = [];
  let line = 0;
  let character = 0;
  for (let i = 0; i < data.length; i += 5) {
    assert.ok(data[i] > 0 || i === 0 || data[i + 1] >= data[i - 3], 'tokens do not overlap');
    character = data[i] > 0 ? data[i + 1] : character + data[i + 1];
    line += data[i];
    assert.ok(data[i + 3] < tokenTypes.length && data[i + 4] < 2 ** tokenModifiers.length);
    assert.ok(data[i + 2] > 0 && character + data[i + 2] <= rows[line].length, `a token of line ${line}`);
    tokens.push({ line, text: rows[line].slice(character, character + data[i + 2]), type: tokenTypes[data[i + 3]] });
  }
  return tokens;
}

session('semanticTokens: full and range', { files }, async (client) => {
  client.open(main);
  const all = decoded(client, files[main], (await client.request('textDocument/semanticTokens/full', client.document(main))).data);
  const has = (line, text, type) => assert.ok(all.some((one) => one.line === line && one.text.toLowerCase() === text && (!type || one.type === type)), `${text} on line ${line}`);
  has(0, '(drills, and faces where the blank is thick)', 'comment');
  has(1, 'sub', 'keyword');
  has(12, 'if', 'keyword');
  has(14, 'elseif', 'keyword');
  has(12, 'o120');
  has(13, 'o<face>');
  has(3, '#1');
  const range = { start: { line: 11, character: 0 }, end: { line: 14, character: 5 } };
  const some = decoded(client, files[main], (await client.request('textDocument/semanticTokens/range', client.document(main, { range }))).data);
  assert.deepEqual(some.filter((one) => one.line < 14), all.filter((one) => one.line >= 11 && one.line < 14));
  assert.ok(some.every((one) => one.line >= 11 && one.line <= 14));
});

session('semanticTokens: only what has changed', { files }, async (client) => {
  client.open(main);
  const full = async () => client.request('textDocument/semanticTokens/full', client.document(main));
  const delta = async (previousResultId) => client.request('textDocument/semanticTokens/full/delta', client.document(main, { previousResultId }));
  const first = await full();
  let data = [...first.data];
  let id = first.resultId;
  for (const change of [['M2\n', '(end)\nM2\n'], ['o120 else\n', 'o120 else (a tight one)\n'], ['(drills, and faces where the blank is thick)\n', ''], ['o100 break', 'o100 continue']]) {
    client.replace(main, change);
    const result = await delta(id);
    assert.ok(Array.isArray(result.edits), 'a change is answered with edits');
    for (const edit of [...result.edits].sort((a, b) => b.start - a.start)) data.splice(edit.start, edit.deleteCount, ...(edit.data ?? []));
    id = result.resultId;
    decoded(client, client.text(main), data);
  }
  assert.deepEqual((await delta(id)).edits, []);
  assert.deepEqual(data, (await full()).data);
  const unknown = await delta('never given out');
  assert.deepEqual(unknown.data, data);
});
