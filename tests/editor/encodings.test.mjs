// Positions in UTF-8, UTF-16 and UTF-32: characters of one to four bytes stand before what is looked at.
import assert from 'node:assert/strict';
import test from 'node:test';
import { locations, session, start } from './client.mjs';
import * as places from './places.mjs';

const program = `o<tür€😀> sub (ä €😀)
  o100 if [#1 EQ 0] (ä €😀)
  o100 endif (ä €😀) G0 X1
o<tür€😀> endsub (ä €😀)
(ä €😀) o110 if [#5070 EQ 0]
  G0 X1
(ä €😀) o110 endif
o<tür€😀> call [1] (ä €😀)
(ä €😀) G0 X[1 + ]
M2
`;
const label = 'o<tür€😀>';

/** What pulled diagnostics say, in the order of lines. */
async function found(client) {
  const all = await client.pulled('program.ngc');
  return all.map((one) => [one.code, one.range]).sort((a, b) => a[1].start.line - b[1].start.line);
}

/** The bracket of `[1 + ]`, before which a number is missing. */
function bracket(client) {
  const { start, end } = client.range('program.ngc', '+ ]');
  return { start: { line: start.line, character: start.character + 2 }, end };
}

for (const [offered, chosen] of [
  [null, 'utf-16'],
  [[], 'utf-16'],
  [['utf-16'], 'utf-16'],
  [['utf-8'], 'utf-8'],
  [['utf-32'], 'utf-32'],
  [['utf-7', 'utf-32'], 'utf-32'],
  [['utf-7'], 'utf-16'],
]) {
  test(`of ${JSON.stringify(offered)} the server takes ${chosen}`, async (t) => {
    const client = await start(t, { encodings: offered });
    assert.equal(client.capabilities.positionEncoding ?? 'utf-16', chosen);
    await client.close();
  });
}

test('of several encodings the server takes one that was offered', async (t) => {
  const client = await start(t, { encodings: ['utf-32', 'utf-8'] });
  assert.ok(['utf-32', 'utf-8'].includes(client.capabilities.positionEncoding));
  await client.close();
});

for (const encodings of [['utf-8'], ['utf-16'], ['utf-32'], null]) {
  const options = { files: { 'program.ngc': program }, encodings };
  const title = encodings?.[0] ?? 'no encoding named';

  session(`${title}: diagnostics`, options, async (client) => {
    client.open('program.ngc');
    const expected = [
      ['OW304', client.range('program.ngc', ['G0 X1', 0])],
      ['OW305', client.range('program.ngc', 'o110 if [#5070 EQ 0]')],
      ['OW305', client.range('program.ngc', 'o110 endif')],
      ['OW303', bracket(client)],
    ];
    assert.deepEqual(await found(client), expected);
  });

  session(`${title}: pushed diagnostics`, { ...options, pull: false }, async (client) => {
    client.open('program.ngc');
    const { diagnostics } = await client.waitDiagnostics('program.ngc', 1);
    const marked = diagnostics.filter((one) => one.code === 'OW304');
    assert.deepEqual(marked.map((one) => one.range), [client.range('program.ngc', ['G0 X1', 0])]);
  });

  session(`${title}: definition`, options, async (client) => {
    client.open('program.ngc');
    const definition = client.range('program.ngc', [label, 0]);
    // The last letter of a word behind the name: off the word if the units are mistaken.
    for (const place of [client.params('program.ngc', 'call', 3), client.params('program.ngc', 'endsub', 5), client.params('program.ngc', [label, 2], 4)]) {
      const targets = locations(await client.request('textDocument/definition', place));
      assert.deepEqual(targets.map((one) => one.range), [definition]);
    }
  });

  session(`${title}: references`, options, async (client) => {
    client.open('program.ngc');
    const all = await client.request('textDocument/references', client.params('program.ngc', 'call', 3, { context: { includeDeclaration: true } }));
    assert.deepEqual(all.map((one) => one.range), [0, 1, 2].map((nth) => client.range('program.ngc', [label, nth])));
  });

  session(`${title}: rename`, options, async (client) => {
    client.open('program.ngc');
    const place = client.params('program.ngc', [label, 2], 4);
    const { range, placeholder } = await client.request('textDocument/prepareRename', place);
    assert.equal(places.slice(program, range, client.encoding), placeholder);
    const edit = await client.request('textDocument/rename', { ...place, newName: placeholder.replace('tür€😀', 'porte😀') });
    assert.equal(client.afterEdit(edit)['program.ngc'], program.replaceAll('tür€😀', 'porte😀'));
  });

  session(`${title}: incremental changes`, options, async (client) => {
    client.open('program.ngc');
    // Into the comment before the marked bracket: longer, shorter, other widths.
    for (const [piece, text] of [['(ä €😀) G0 X[', '(ä xyz😀😀) G0 X['], ['yz😀😀', 'yé'], ['ä xyé', '😀😀😀']]) {
      client.replace('program.ngc', [piece, text]);
      assert.deepEqual((await found(client)).at(-1), ['OW303', bracket(client)]);
    }
    // Several changes in one notification: each speaks of the text that the one before it left.
    client.replace('program.ngc', ['(😀😀😀) G0', '(ß😀)(€) G0'], ['(€) G0', 'G0'], ['o<tür€😀> call [1]', '(🙂)\no<tür€😀> call [1]']);
    assert.deepEqual((await found(client)).at(-1), ['OW303', bracket(client)]);
    client.replace('program.ngc', ['[1 + ]', '[1 + 2]'], ['(ä €😀) G0 X1', '(€😀)']);
    assert.deepEqual((await found(client)).map(([code]) => code), ['OW305', 'OW305']);
  });

  session(`${title}: semantic tokens`, options, async (client) => {
    client.open('program.ngc');
    const { tokenTypes } = client.capabilities.semanticTokensProvider.legend;
    const { data } = await client.request('textDocument/semanticTokens/full', client.document('program.ngc'));
    const tokens = [];
    let line = 0;
    let character = 0;
    for (let i = 0; i < data.length; i += 5) {
      character = data[i] > 0 ? data[i + 1] : character + data[i + 1];
      line += data[i];
      tokens.push({ line, character, length: data[i + 2], type: tokenTypes[data[i + 3]] });
    }
    const comment = client.range('program.ngc', ['(ä €😀)', 0]);
    assert.deepEqual(tokens.filter((token) => token.line === 0 && token.type === 'comment'), [
      { line: 0, character: comment.start.character, length: places.width('(ä €😀)', client.encoding), type: 'comment' },
    ]);
    const keyword = client.range('program.ngc', ['sub (', 0]).start;
    assert.ok(tokens.some((token) => token.line === 0 && token.character === keyword.character && token.length === 3 && token.type === 'keyword'));
  });
}
