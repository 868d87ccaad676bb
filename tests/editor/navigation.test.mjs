// Getting about: from parts of blocks to their openers, from calls to subs in other files, and the lists of both.
import assert from 'node:assert/strict';
import { locations, session } from './client.mjs';
import * as places from './places.mjs';
import { files } from './shop.mjs';

const main = 'main.ngc';
const onDisk = { files };

/** Start lines of ranges, sorted. */
const lines = (list) => list.map((one) => (one.range ?? one).start.line).sort((a, b) => a - b);

/** All of a tree of symbols, each with its parent. */
function flat(symbols, parent) {
  return symbols.flatMap((one) => [{ ...one, parent }, ...flat(one.children ?? [], one)]);
}

const definitions = [
  ['else of an if', 'o120 else\n', 5, main, ['o120', 0]],
  ['elseif', 'o120 elseif', 0, main, ['o120', 0]],
  ['endif, its label', 'o120 endif', 2, main, ['o120', 0]],
  ['the opener itself', 'o120 if', 1, main, ['o120', 0]],
  ['break', 'o100 break', 6, main, ['o100', 2]],
  ['endwhile', 'o100 endwhile', 8, main, ['o100', 2]],
  ['endrepeat: the block of that label in its sub', 'o100 endrepeat', 8, main, ['o100', 0]],
  ['a call in the same file', 'o<drill> call [20]', 3, main, ['o<drill>', 0]],
  ['return', 'o<drill> return', 12, main, ['o<drill>', 0]],
  ['endsub', 'o<drill> endsub', 4, main, ['o<drill>', 0]],
  ['a call of another file', 'o<face> call', 9, 'face.ngc', ['o<face>', 0]],
];
for (const method of ['textDocument/definition', 'textDocument/declaration']) {
  session(`${method}`, onDisk, async (client) => {
    client.open(main);
    for (const [what, piece, into, file, target] of definitions) {
      const found = locations(await client.request(method, client.params(main, piece, into)));
      assert.deepEqual(found.map((one) => client.name(one.uri)), [file], what);
      assert.deepEqual(found[0].range, client.range(file, target), what);
    }
    for (const piece of ['G21 G90', 'faces where', 'M2']) {
      assert.deepEqual(locations(await client.request(method, client.params(main, piece, 1))), [], piece);
    }
  });
}

session('M98 leads to its O number', onDisk, async (client) => {
  client.open('fanuc.ngc');
  const found = locations(await client.request('textDocument/definition', client.params('fanuc.ngc', 'P100', 2)));
  assert.deepEqual(found, [{ uri: client.uri('fanuc.ngc'), range: client.range('fanuc.ngc', 'O100') }]);
});

session('a call leads to the sub as it stands in the editor', onDisk, async (client) => {
  client.open(main);
  client.open('face.ngc', `(moved\n(down)\n\n${files['face.ngc']}`.replace('(moved\n', '(moved)\n'));
  const [found] = locations(await client.request('textDocument/definition', client.params(main, 'o<face> call', 3)));
  assert.equal(found.range.start.line, 4);
});

const references = (client, file, piece, into, includeDeclaration = true) =>
  client.request('textDocument/references', client.params(file, piece, into, { context: { includeDeclaration } }));

session('references of a block', onDisk, async (client) => {
  client.open(main);
  const all = await references(client, main, 'o120 else\n', 2);
  assert.deepEqual(all.map((one) => one.range), [0, 1, 2, 3].map((nth) => client.range(main, ['o120', nth])));
  assert.ok(all.every((one) => one.uri === client.uri(main)));
  assert.deepEqual(lines(await references(client, main, 'o120 else\n', 2, false)), [14, 16, 18]);
  assert.deepEqual(lines(await references(client, main, 'o100 break', 2)), [11, 15, 19], 'without the block of that label in the sub');
  assert.deepEqual(lines(await references(client, main, 'o100 endrepeat', 2)), [2, 7]);
});

session('references of a sub', onDisk, async (client) => {
  client.open(main);
  assert.deepEqual(lines(await references(client, main, 'o<drill> call [10]', 3)), [1, 5, 8, 10, 17]);
  assert.deepEqual(lines(await references(client, main, 'o<drill> sub', 3, false)), [5, 8, 10, 17]);
  const all = await references(client, main, 'o<face> call', 3);
  const found = all.map((one) => `${client.name(one.uri)}:${one.range.start.line}`).sort();
  assert.deepEqual(found, ['both.ngc:2', 'both.ngc:3', 'face.ngc:1', 'face.ngc:5', 'face.ngc:6', 'main.ngc:13']);
});

session('documentHighlight shows the whole block', onDisk, async (client) => {
  client.open(main);
  const highlights = async (piece, into) => client.request('textDocument/documentHighlight', client.params(main, piece, into));
  assert.deepEqual(lines(await highlights('o120 elseif', 7)), [12, 14, 16, 18]);
  assert.deepEqual(lines(await highlights('o100 break', 7)), [11, 15, 19]);
  assert.deepEqual(lines(await highlights('o<drill> sub', 3)), [1, 5, 8, 10, 17]);
  for (const one of await highlights('o120 if', 2)) {
    assert.match(places.slice(client.text(main), one.range, client.encoding), /^o120( (if|elseif|else|endif))?$/);
  }
  assert.deepEqual((await highlights('G21', 1)) ?? [], []);
});

session('documentSymbol: subs hold blocks, blocks hold blocks', onDisk, async (client) => {
  client.open(main);
  const symbols = flat(await client.request('textDocument/documentSymbol', client.document(main)));
  for (const one of symbols) {
    assert.ok(places.contains(one.range, one.selectionRange), `${one.name}: its selectionRange`);
    assert.ok(!one.parent || places.contains(one.parent.range, one.range), `${one.name}: inside ${one.parent?.name}`);
  }
  const at = (line) => symbols.find((one) => one.selectionRange.start.line === line && !/main/.test(one.name));
  const expected = [[1, 8, /drill/], [2, 7, /o100/], [4, 6, /o110/], [11, 19, /o100/], [12, 18, /o120/]];
  for (const [line, last, name] of expected) {
    assert.match(at(line).name, name);
    assert.equal(at(line).range.start.line, line);
    assert.equal(at(line).range.end.line, last);
  }
  assert.equal(at(1).kind, 12, 'a sub is a function');
  assert.equal(at(2).parent.name, at(1).name);
  assert.equal(at(4).parent.name, at(2).name);
  assert.equal(at(12).parent.name, at(11).name);
});

session('workspace/symbol finds subs in all files', onDisk, async (client) => {
  const search = async (query) => (await client.request('workspace/symbol', { query })) ?? [];
  const faces = await search('fac');
  assert.deepEqual(faces.map((one) => client.name(one.location.uri)), ['face.ngc']);
  assert.match(faces[0].name, /face/);
  assert.equal(faces[0].kind, 12);
  assert.equal(faces[0].location.range.start.line, 1);
  assert.deepEqual(await search('no such sub'), []);
  const all = (await search('')).map((one) => client.name(one.location.uri));
  for (const name of ['both.ngc', 'face.ngc', main]) assert.ok(all.includes(name), name);
});

session('foldingRange', onDisk, async (client) => {
  client.open(main);
  const folds = await client.request('textDocument/foldingRange', client.document(main));
  for (const fold of folds) assert.ok(fold.startLine >= 0 && fold.startLine < fold.endLine && fold.endLine < 21, JSON.stringify(fold));
  // The line that ends a block may stay in sight; an `if` may fold part by part.
  for (const [first, ...last] of [[1, 7, 8], [2, 6, 7], [4, 5, 6], [11, 18, 19], [12, 13, 17, 18]]) {
    assert.ok(folds.some((fold) => fold.startLine === first && last.includes(fold.endLine)), `from line ${first}: ${JSON.stringify(folds)}`);
  }
});

session('selectionRange grows from the word to the program', onDisk, async (client) => {
  client.open(main);
  const positions = [client.at(main, 'o<drill> return', 10), client.at(main, 'G21', 1)];
  const chains = await client.request('textDocument/selectionRange', client.document(main, { positions }));
  assert.equal(chains.length, 2);
  for (const [i, chain] of chains.entries()) {
    assert.ok(places.contains(chain.range, { start: positions[i], end: positions[i] }));
    for (let one = chain; one.parent; one = one.parent) {
      assert.ok(places.contains(one.parent.range, one.range));
      assert.notDeepEqual(one.parent.range, one.range);
    }
  }
  const spans = [];
  for (let one = chains[0]; one; one = one.parent) spans.push(`${one.range.start.line}-${one.range.end.line}`);
  for (const span of ['5-5', '4-6', '2-7', '1-8']) assert.ok(spans.includes(span), `${span} in ${spans}`);
  assert.ok(spans.at(-1).startsWith('0-'));
});

session('documentLink: called files', onDisk, async (client) => {
  client.open(main);
  const links = await client.request('textDocument/documentLink', client.document(main));
  assert.deepEqual(links.map((one) => client.name(one.target)), ['face.ngc']);
  assert.match(places.slice(files[main], links[0].range, client.encoding), /^(o?<)?face>?$/);
});

session('codeLens counts the calls of subs', onDisk, async (client) => {
  const titles = async (name) => {
    client.open(name);
    const lenses = await client.request('textDocument/codeLens', client.document(name));
    return lenses.map((one) => `${one.range.start.line} ${one.command.title}`);
  };
  const [drill, ...others] = await titles(main);
  assert.match(drill, /^1 2 calls\b/);
  assert.deepEqual(others, []);
  assert.match((await titles('face.ngc'))[0], /^1 3 calls\b/, 'from two files');
  assert.match((await titles('both.ngc'))[0], /^1 (no|0) calls\b/);
});

session('call hierarchy', onDisk, async (client) => {
  client.open(main);
  const prepare = async (name, piece, into) => client.request('textDocument/prepareCallHierarchy', client.params(name, piece, into));
  const [face, ...others] = await prepare(main, 'o<face> call', 3);
  assert.deepEqual(others, []);
  assert.match(face.name, /face/);
  assert.equal(face.kind, 12);
  assert.equal(client.name(face.uri), 'face.ngc');
  assert.deepEqual(face.selectionRange.start, client.range('face.ngc', ['o<face>', 0]).start);
  assert.ok(places.contains(face.range, face.selectionRange));

  const incoming = await client.request('callHierarchy/incomingCalls', { item: face });
  const from = Object.fromEntries(incoming.map((one) => [client.name(one.from.uri), one]));
  assert.deepEqual(Object.keys(from).sort(), ['both.ngc', main]);
  assert.match(from['both.ngc'].from.name, /both/);
  assert.deepEqual(lines(from['both.ngc'].fromRanges), [2, 3]);
  assert.deepEqual(lines(from[main].fromRanges), [13]);

  const [drill] = await prepare(main, 'o<drill> sub', 3);
  const callers = await client.request('callHierarchy/incomingCalls', { item: drill });
  assert.equal(callers.length, 1);
  assert.deepEqual(lines(callers[0].fromRanges), [10, 17]);
  const called = await client.request('callHierarchy/outgoingCalls', { item: callers[0].from });
  const to = Object.fromEntries(called.map((one) => [/drill|face/.exec(one.to.name)[0], lines(one.fromRanges)]));
  assert.deepEqual(to, { drill: [10, 17], face: [13] });
  const [outgoing, ...more] = await client.request('callHierarchy/outgoingCalls', { item: from['both.ngc'].from });
  assert.deepEqual(more, []);
  assert.equal(client.name(outgoing.to.uri), 'face.ngc');
  assert.deepEqual(lines(outgoing.fromRanges), [2, 3]);
  // A line outside of all subs belongs to the program, if to anything.
  for (const item of (await prepare(main, 'G21', 1)) ?? []) assert.deepEqual([item.name, item.kind], [main, 1]);
});

const shop = { 'programs/caller.ngc': 'o<far> call\nM2\n', 'macros/far.ngc': 'o<far> sub\no<far> endsub\n' };
for (const [who, options] of [
  ['owlint.toml', { files: { ...shop, 'programs/owlint.toml': 'sub-path = ["../macros"]\n' } }],
  ['the client', { files: shop, options: { 'sub-path': ['macros'] } }],
]) {
  session(`a call leads to a file in a folder of sub-path: ${who}`, options, async (client) => {
    client.open('programs/caller.ngc');
    const found = locations(await client.request('textDocument/definition', client.params('programs/caller.ngc', 'o<far> call', 3)));
    assert.deepEqual(found.map((one) => client.name(one.uri)), ['macros/far.ngc']);
  });
}
