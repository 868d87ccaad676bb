// From the first message to the last: initialize, shutdown, exit, and what is refused or ignored in between.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import test from 'node:test';
import { codes, session, start } from './client.mjs';
import { RawPeer, frame, initialize, program } from './raw.mjs';

const sound = 'G21 G90\no100 if [#5070 EQ 0]\n  G0 X1\no100 endif\nM2\n';

session('initialize tells what the server can do', {}, async (client) => {
  const can = client.capabilities;
  assert.equal(client.result.serverInfo.name, 'owlint');
  assert.equal(`owlint ${client.result.serverInfo.version}`, execFileSync(program, ['--version'], { encoding: 'utf8' }).split('\n')[0]);

  const sync = can.textDocumentSync;
  assert.equal(sync.openClose, true);
  assert.equal(sync.change, 2, 'changes are incremental');
  for (const feature of [
    'definition', 'declaration', 'references', 'documentHighlight', 'documentSymbol', 'workspaceSymbol', 'foldingRange',
    'selectionRange', 'documentLink', 'codeLens', 'callHierarchy', 'hover', 'inlayHint', 'documentFormatting',
    'documentRangeFormatting',
  ]) {
    assert.ok(can[`${feature}Provider`], `${feature}Provider`);
  }
  assert.equal(can.renameProvider.prepareProvider, true);
  assert.ok(can.completionProvider.triggerCharacters.includes('<'));
  assert.ok(can.signatureHelpProvider.triggerCharacters.includes('['));
  assert.equal(can.documentOnTypeFormattingProvider.firstTriggerCharacter, '\n');
  assert.equal(can.diagnosticProvider.interFileDependencies, true);
  assert.equal(can.diagnosticProvider.workspaceDiagnostics, true);
  assert.ok(can.codeActionProvider.codeActionKinds.includes('quickfix'));
  assert.ok(can.codeActionProvider.codeActionKinds.includes('source.fixAll.owlint'));
  assert.ok(can.executeCommandProvider.commands.length > 0);
  assert.equal(can.workspace.workspaceFolders.supported, true);
  const tokens = can.semanticTokensProvider;
  assert.ok(['keyword', 'comment'].every((type) => tokens.legend.tokenTypes.includes(type)));
  assert.ok(Array.isArray(tokens.legend.tokenModifiers));
  assert.equal(tokens.full.delta, true);
  assert.ok(tokens.range);
});

test('files are watched where the client can be asked to', async (t) => {
  const client = await start(t);
  await client.request('workspace/symbol', { query: '' });
  assert.ok(client.asked.includes('client/registerCapability'), `asked: ${client.asked}`);
  await client.close();
});

test('requests before initialize are refused, notifications dropped', async (t) => {
  const client = await start(t, { bare: true });
  assert.equal((await client.refusal('textDocument/hover', { textDocument: { uri: 'file:///a.ngc' }, position: { line: 0, character: 0 } })).code, -32002);
  assert.equal((await client.refusal('shutdown')).code, -32002);
  client.open('early.ngc', 'o100 if [1]\n');
  await client.initialize({ pull: false });
  client.open('later.ngc', sound);
  await client.waitDiagnostics('later.ngc', 1);
  assert.deepEqual(client.published.filter((one) => one.uri === client.uri('early.ngc')), []);
  await client.close();
});

session('a second initialize is refused', {}, async (client) => {
  const error = await client.refusal('initialize', { processId: null, rootUri: null, capabilities: {} });
  assert.equal(error.code, -32600);
});

session('unknown methods', {}, async (client) => {
  assert.equal((await client.refusal('textDocument/nonsense', {})).code, -32601);
  assert.equal((await client.refusal('$/nonsense', {})).code, -32601);
  client.notify('owlint/nonsense', { any: [1] });
  client.notify('$/nonsense', {});
  client.notify('$/setTrace', { value: 'verbose' });
  client.open('a.ngc', sound);
  assert.deepEqual(await client.pulled('a.ngc'), []);
});

session('a client that knows next to nothing is served', { bare: true }, async (client) => {
  const result = await client.request('initialize', { processId: null, rootUri: null, capabilities: {} });
  assert.equal(result.capabilities.positionEncoding ?? 'utf-16', 'utf-16');
  client.notify('initialized', {});
  client.open('a.ngc', sound.replace('endif', 'endwhile'));
  const { diagnostics } = await client.waitDiagnostics('a.ngc', undefined, (all) => all.length > 0);
  assert.match(codes(diagnostics).join(), /^OW[12]\d\d/);
});

session('$/cancelRequest', { files: { 'a.ngc': sound } }, async (client) => {
  client.notify('$/cancelRequest', { id: 'never sent' });
  client.notify('$/cancelRequest', { id: 123456 });
  client.open('a.ngc');
  assert.deepEqual(await client.pulled('a.ngc'), []);
});

test('a cancelled request is answered once: with a result, or with the code for it', async (t) => {
  const peer = new RawPeer(t);
  await peer.start();
  const textDocument = { uri: 'file:///nowhere/a.ngc' };
  peer.send({ method: 'textDocument/didOpen', params: { textDocument: { ...textDocument, languageId: 'gcode', version: 1, text: sound } } });
  for (let id = 1; id <= 20; ++id) {
    peer.send({ id, method: 'textDocument/foldingRange', params: { textDocument } });
    peer.send({ method: '$/cancelRequest', params: { id } });
  }
  peer.send({ id: 21, method: 'textDocument/foldingRange', params: { textDocument } });
  assert.ok((await peer.answer(21)).result.length > 0, 'one that was not cancelled');
  for (let id = 1; id <= 20; ++id) {
    const answers = peer.received.filter((message) => message.id === id && message.method === undefined);
    assert.equal(answers.length, 1);
    if (answers[0].error) assert.equal(answers[0].error.code, -32800);
    else assert.ok(Array.isArray(answers[0].result));
  }
  await peer.finish();
});

test('ids come back as they were sent', async (t) => {
  const peer = new RawPeer(t);
  const { capabilities } = await peer.start();
  assert.equal(typeof capabilities, 'object');
  for (const id of ['seven', '7', 7, 0, -1, 2 ** 31 - 1]) {
    peer.send({ id, method: 'owlint/nonsense' });
    const answer = await peer.answer(id);
    assert.equal(answer.jsonrpc, '2.0');
    assert.equal(answer.error.code, -32601);
    assert.equal(typeof answer.error.message, 'string');
    assert.ok(!('result' in answer));
  }
  await peer.finish();
});

test('after shutdown requests are refused, and exit ends with status 0', async (t) => {
  const client = await start(t);
  assert.equal(await client.request('shutdown'), null);
  assert.equal((await client.refusal('workspace/symbol', { query: '' })).code, -32600);
  assert.equal((await client.refusal('shutdown')).code, -32600);
  client.open('a.ngc', sound); // a notification: dropped
  await client.notify('exit');
  assert.deepEqual(await client.ended(), { status: 0, signal: null });
});

test('exit without shutdown ends with status 1', async (t) => {
  const client = await start(t);
  await client.notify('exit');
  assert.deepEqual(await client.ended(), { status: 1, signal: null });
});

test('exit before initialize ends with status 1', async (t) => {
  const peer = new RawPeer(t);
  peer.send({ method: 'exit' });
  assert.deepEqual(await peer.end(), { status: 1, signal: null });
});

for (const [when, messages] of [
  ['at once', []],
  ['after initialize', [initialize]],
  ['after shutdown', [initialize, { id: 2, method: 'shutdown' }]],
]) {
  test(`input that ends ${when} ends the server with status 1`, async (t) => {
    const peer = new RawPeer(t);
    for (const message of messages) {
      peer.send(message);
      assert.ok('result' in (await peer.answer(message.id)));
    }
    peer.child.stdin.end();
    assert.deepEqual(await peer.end(), { status: 1, signal: null });
  });
}

test('exit ends the server cleanly, whatever stands behind it', async (t) => {
  // Many times: a thread that still reads must not meet what is being taken down.
  for (let round = 0; round < 40; ++round) {
    const peer = new RawPeer(t);
    await peer.start();
    peer.send({ id: 2, method: 'shutdown' });
    await peer.answer(2);
    peer.write(frame({ method: 'exit' }).repeat(1 + (round % 3)));
    if (round % 2 === 0) peer.child.stdin.end();
    assert.deepEqual(await peer.end(), { status: 0, signal: null }, `round ${round}: ${peer.child.complaints}`);
  }
});
