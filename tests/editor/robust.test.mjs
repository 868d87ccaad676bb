// What no client should send, and what unlucky ones do: broken messages, wrong params, positions outside, an end midway.
import assert from 'node:assert/strict';
import test from 'node:test';
import { codes, session } from './client.mjs';
import { RawPeer, frame, initialize, initialized } from './raw.mjs';

const twice = 'G21 G90\no100 if [#5070 EQ 0]\n  G0 X1\no100 endif\no100 if [#5070 EQ 1]\n  G0 X3\no100 endif\nM2\n';

for (const [what, body] of [
  ['cut off', '{"jsonrpc": "2.0", "id": 1, "method"'],
  ['no JSON', 'o100 if [#1]'],
  ['empty', ''],
  ['no UTF-8', Buffer.from([0x7b, 0x22, 0xff, 0xfe, 0x22, 0x3a, 0x31, 0x7d])],
  ['a number of brackets', '['.repeat(100_000)],
]) {
  test(`a body that is ${what} is refused, and the server lives on`, async (t) => {
    const peer = new RawPeer(t);
    peer.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n`);
    peer.write(body);
    const refusal = await peer.message((message) => message.error !== undefined, 'the refusal');
    assert.equal(refusal.error.code, -32700);
    assert.equal(refusal.id, null);
    await peer.start();
    peer.write(frame('{"half": '));
    await peer.message((message, i) => message.error?.code === -32700 && i > 1, 'the second refusal');
    await peer.finish();
  });
}

for (const [what, message] of [
  ['a number', '42'],
  ['null', 'null'],
  ['a string', '"initialize"'],
  ['a batch', '[{"jsonrpc": "2.0", "id": 1, "method": "shutdown"}]'],
  ['without a method', '{"jsonrpc": "2.0", "id": 1}'],
  ['one whose method is a number', '{"jsonrpc": "2.0", "id": 1, "method": 5}'],
  ['one that speaks of cancelling', '{"jsonrpc": "2.0", "id": 1, "method": 5, "params": "$/cancelRequest"}'],
  ['lists in lists', '['.repeat(50_000) + ']'.repeat(50_000)],
]) {
  test(`a message that is ${what} is no request`, async (t) => {
    const peer = new RawPeer(t);
    await peer.start();
    peer.write(frame(message));
    const { error } = await peer.message((one) => one.error !== undefined, 'the refusal');
    assert.equal(error.code, -32600);
    await peer.finish();
  });
}

test('answers to nothing are ignored', async (t) => {
  const peer = new RawPeer(t);
  await peer.start();
  peer.send({ id: 'never asked', result: { any: 1 } });
  peer.send({ id: 99, error: { code: -32601, message: 'no such method' } });
  await peer.finish();
  assert.deepEqual(peer.received.filter((one) => one.error), []);
});

test('messages may come in pieces, several at once, with other headers', async (t) => {
  const peer = new RawPeer(t);
  for (const byte of frame(initialize)) peer.write(byte);
  assert.ok((await peer.answer('first')).result.capabilities);
  const type = 'Content-Type: application/vscode-jsonrpc; charset=utf-8\r\n';
  const ask = { method: 'workspace/symbol', params: { query: '' } };
  peer.write(frame(initialized) + frame({ id: 2, ...ask }, type) + type + frame({ id: 3, ...ask }));
  assert.ok('result' in (await peer.answer(2)));
  assert.ok('result' in (await peer.answer(3)));
  await peer.finish();
});

for (const header of [
  'Content-Type: text/plain\r\n\r\n',
  'Content-Length: many\r\n\r\n',
  'Content-Length: -5\r\n\r\n',
  'Content-Length: 99999999999999999999999\r\n\r\n',
  'Content-Length: 9223372036854775807\r\n\r\n',
  'Content-Length:\r\n\r\n',
  '\r\n\r\n',
  'o100 if [#1 EQ 2]\r\n\r\n',
  `${'x'.repeat(1_000_000)}\r\n\r\n`,
  '\0\x01\x02\xff\n\n\n',
]) {
  test(`a header like ${JSON.stringify(header.slice(0, 48))}: the server reads on, or says why it ends`, async (t) => {
    const peer = new RawPeer(t);
    peer.write(Buffer.from(header, 'latin1'));
    peer.send(initialize);
    peer.child.stdin.end();
    assert.deepEqual(await peer.end(), { status: 1, signal: null });
    const answered = peer.received.some((one) => one.id === 'first' && one.result);
    assert.ok(answered || /owlint: \S/.test(peer.child.complaints), `neither an answer nor a reason: ${peer.child.complaints}`);
  });
}

for (const [what, bytes] of [
  ['a header', 'Content-Len'],
  ['headers', 'Content-Length: 50\r\n'],
  ['a body', 'Content-Length: 50\r\n\r\n{"jsonrpc"'],
]) {
  test(`the client vanishes in the middle of ${what}`, async (t) => {
    const peer = new RawPeer(t);
    await peer.start();
    peer.write(bytes);
    peer.child.stdin.end();
    assert.deepEqual(await peer.end(), { status: 1, signal: null });
  });
}

test('the client no longer reads', async (t) => {
  const peer = new RawPeer(t);
  await peer.start();
  peer.child.stdout.destroy();
  for (let id = 1; id <= 200; ++id) peer.send({ id, method: 'workspace/symbol', params: { query: '' } });
  peer.child.stdin.end();
  assert.deepEqual(await peer.end(), { status: 1, signal: null });
});

const somewhere = { line: 0, character: 0 };
session('wrong params are refused', {}, async (client) => {
  client.open('a.ngc', twice);
  const textDocument = { uri: client.uri('a.ngc') };
  for (const [method, params] of [
    ['textDocument/hover', {}],
    ['textDocument/hover', { textDocument }],
    ['textDocument/hover', { position: somewhere }],
    ['textDocument/hover', { textDocument: 'a.ngc', position: somewhere }],
    ['textDocument/hover', { textDocument: { uri: 5 }, position: somewhere }],
    ['textDocument/definition', { textDocument, position: { line: 'first', character: 0 } }],
    ['textDocument/definition', { textDocument, position: [0, 0] }],
    ['textDocument/rename', { textDocument, position: { line: 1, character: 1 } }],
    ['textDocument/rename', { textDocument, position: { line: 1, character: 1 }, newName: 110 }],
    ['textDocument/codeAction', { textDocument, context: { diagnostics: [] } }],
    ['textDocument/selectionRange', { textDocument, positions: 7 }],
    ['textDocument/inlayHint', { textDocument, range: { start: somewhere } }],
    ['textDocument/semanticTokens/full', {}],
    ['textDocument/diagnostic', { textDocument: {} }],
    ['textDocument/formatting', { options: { tabSize: 2, insertSpaces: true } }],
    ['textDocument/formatting', { textDocument, options: { tabSize: 'two', insertSpaces: true } }],
    ['callHierarchy/incomingCalls', {}],
    ['workspace/symbol', { query: {} }],
    ['workspace/executeCommand', { arguments: [] }],
    ['workspace/executeCommand', { command: 'owlint.explain', arguments: [{}] }],
  ]) {
    assert.equal((await client.refusal(method, params)).code, -32602, `${method} ${JSON.stringify(params)}`);
  }
  const unknown = await client.refusal('textDocument/hover', { textDocument: { uri: client.uri('none.ngc') }, position: somewhere });
  assert.ok([-32602, -32803].includes(unknown.code));
});

session('wrong notifications are dropped', {}, async (client) => {
  const textDocument = { uri: client.uri('a.ngc'), version: 2 };
  const range = { start: somewhere, end: somewhere };
  client.notify('textDocument/didOpen', {});
  client.notify('textDocument/didOpen', { textDocument: { uri: 5, text: [] } });
  client.notify('textDocument/didChange', { textDocument, contentChanges: [{ range, text: 'x' }] }); // not open
  client.notify('textDocument/didClose', { textDocument });
  client.open('a.ngc', twice);
  client.notify('textDocument/didChange', { textDocument });
  client.notify('textDocument/didChange', { textDocument, contentChanges: {} });
  client.notify('textDocument/didChange', { textDocument, contentChanges: [{ range: 'all', text: 'x' }] });
  client.notify('textDocument/didChange', { textDocument, contentChanges: [{ range }] });
  client.notify('workspace/didChangeWatchedFiles', { changes: 'all' });
  client.notify('workspace/didChangeConfiguration', { settings: [] });
  client.notify('workspace/didChangeWorkspaceFolders', {});
  assert.deepEqual(codes(await client.pulled('a.ngc')), ['OW104']);
});

const latin1 = {
  'face.ngc': Buffer.from('(Fl\u00e4che, H\u00f6he #1)\no<face> sub\n  G0 Z#1 (\u00fcber 0)\no<face> endsub\no<w\u00fcrfel> sub\n  o1\u00e4 wile [#1]\n', 'latin1'),
};
session('files that are not UTF-8', { files: latin1 }, async (client) => {
  client.open('main.ngc', 'o<face> call [1]\nM2\n');
  const place = client.params('main.ngc', 'o<face>', 3);
  assert.match(JSON.stringify(await client.request('textDocument/hover', place)), /Fl.+che, H.+he #1/);
  assert.match(JSON.stringify(await client.request('textDocument/signatureHelp', client.params('main.ngc', '[1]', 1))), /Fl.+che/);
  const [symbol] = await client.request('workspace/symbol', { query: 'rfel' });
  assert.equal(client.name(symbol.location.uri), 'face.ngc');
  for (const method of ['documentSymbol', 'codeLens', 'semanticTokens/full']) {
    assert.ok(await client.request(`textDocument/${method}`, client.document('face.ngc')), method);
  }
  const { items } = await client.request('workspace/diagnostic', { previousResultIds: [] });
  const found = items.find((item) => client.name(item.uri) === 'face.ngc').items;
  assert.ok(found.some((one) => one.severity <= 2), 'what is wrong in it is reported');
});

session('other schemes than files', {}, async (client) => {
  for (const uri of ['untitled:Untitled-1', 'vscode-notebook-cell:/a.ngc#W0', 'git:/a.ngc?ref=HEAD']) {
    client.open(uri, twice);
    assert.deepEqual(codes(await client.pulled(uri)), ['OW104'], uri);
    client.closeDocument(uri);
  }
});

session('positions outside of the text are taken back into it', {}, async (client) => {
  client.open('a.ngc', twice);
  const far = { line: 2 ** 31 - 1, character: 2 ** 31 - 1 };
  for (const method of ['hover', 'definition', 'prepareRename', 'documentHighlight', 'completion', 'signatureHelp']) {
    const result = await client.request(`textDocument/${method}`, client.document('a.ngc', { position: far }));
    assert.ok(result === null || typeof result === 'object', method);
  }
  // Behind the end of a line is its end: the label there is at its last character.
  const behind = { line: 3, character: 5000 };
  const [found] = [await client.request('textDocument/definition', client.document('a.ngc', { position: behind }))].flat();
  assert.equal((found.targetSelectionRange ?? found.range).start.line, 1);
  // A whole new text, by a range that reaches too far.
  client.change('a.ngc', [{ range: { start: somewhere, end: far }, text: `(new)\n${twice}` }], `(new)\n${twice}`);
  const [one] = await client.pulled('a.ngc');
  assert.deepEqual(one.range, client.range('a.ngc', ['o100', 2]));
  // Something behind the last line, and behind the end of a line: not into the next.
  client.change('a.ngc', [{ range: { start: far, end: far }, text: '(end)' }], `(new)\n${twice}(end)`);
  client.change('a.ngc', [{ range: { start: { line: 5, character: 999 }, end: { line: 5, character: 1999 } }, text: ' G0' }], client.text('a.ngc').replace('1]\n', '1] G0\n'));
  const marked = (await client.pulled('a.ngc')).map((each) => [each.code, each.range]);
  assert.deepEqual(marked.find(([code]) => code === 'OW304')[1], client.range('a.ngc', ['G0', 1]));
});

for (const encoding of ['utf-8', 'utf-16']) {
  session(`edits in the middle of a character: ${encoding}`, { encodings: [encoding] }, async (client) => {
    const text = `(€😀)${twice}`;
    client.open('a.ngc', text);
    const last = encoding === 'utf-8' ? 9 : 5;
    for (let from = 0; from <= last; ++from) {
      for (let to = from; to <= last; ++to) {
        const range = { start: { line: 0, character: from }, end: { line: 0, character: to } };
        client.change('a.ngc', [{ range, text: 'ä' }], text);
        const answer = await client.request('textDocument/documentSymbol', client.document('a.ngc'));
        assert.equal(answer.length, 2, 'the lines below are as they were');
        client.replaceAll('a.ngc', text);
        assert.deepEqual((await client.pulled('a.ngc')).map((one) => one.range), [client.range('a.ngc', ['o100', 2])]);
      }
    }
  });
}
