// A client as an editor is one: the library of VS Code, with all capabilities, in a temporary folder of its own.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import protocol from 'vscode-languageserver-protocol/node.js';
import { fullCapabilities } from './capabilities.mjs';
import * as places from './places.mjs';
import { fromServer, startProgram, within } from './raw.mjs';

const { StreamMessageReader, StreamMessageWriter, createProtocolConnection } = protocol;
const corpusFolder = fileURLToPath(new URL('../../corpus/', import.meta.url));

export function corpus(name) {
  const bytes = fs.readFileSync(corpusFolder + name);
  return bytes.toString(name.includes('latin1') ? 'latin1' : 'utf8');
}

export function corpusNames() {
  return fs.readdirSync(corpusFolder).filter((name) => name.endsWith('.ngc'));
}

/** A test with a started client, which is closed after it: the server must then end with status 0. */
export function session(title, options, body) {
  test(title, async (t) => {
    const client = await start(t, options);
    await body(client, t);
    await client.close();
  });
}

/**
 * Starts a server. `files`: texts on disk, by name. `encodings`: the client's positionEncodings; null leaves them out.
 * `pull`: whether the client asks for diagnostics itself. `bare`: leave out the handshake.
 */
export async function start(t, { files = {}, encodings = ['utf-16'], pull = true, bare = false, options } = {}) {
  const client = new Client(t, files);
  if (!bare) await client.initialize({ encodings, pull, options });
  return client;
}

export class Client {
  encoding = 'utf-16';
  texts = {}; // by uri: what is open, or on disk as it was at the start
  published = [];
  shown = []; // what the server wanted to be shown
  asked = []; // methods of the server's own requests
  progress = []; // reports of long work
  #versions = new Map();
  #waiting = new Set();

  constructor(t, files) {
    // Blanks and letters that a uri cannot have as they are.
    this.folder = fs.realpathSync(fs.mkdtempSync(path.join(os.tmpdir(), 'owlint werkstück ')));
    t.after(() => fs.rmSync(this.folder, { recursive: true, force: true }));
    for (const [name, text] of Object.entries(files)) this.writeFile(name, text);
    this.child = startProgram(t, this.folder);
    this.connection = createProtocolConnection(new StreamMessageReader(this.child.stdout), new StreamMessageWriter(this.child.stdin));
    this.connection.onError(() => {}); // a server that has ended: the waits tell
    this.connection.onNotification('textDocument/publishDiagnostics', (params) => {
      this.published.push(params);
      for (const look of [...this.#waiting]) look();
    });
    this.connection.onRequest('window/showDocument', (params) => {
      this.shown.push(JSON.stringify(params));
      return { success: true };
    });
    this.connection.onNotification('window/showMessage', (params) => this.shown.push(params.message));
    this.connection.onUnhandledProgress((report) => this.progress.push(report));
    this.connection.onRequest((method) => {
      this.asked.push(method);
      return null;
    });
    this.connection.listen();
    t.after(() => this.connection.dispose());
  }

  async initialize({ encodings = ['utf-16'], pull = true, options } = {}) {
    const uri = pathToFileURL(this.folder).href;
    this.result = await this.request('initialize', {
      processId: process.pid,
      clientInfo: { name: 'owlint-editor-tests' },
      rootUri: uri,
      workspaceFolders: [{ uri, name: 'shop' }],
      capabilities: fullCapabilities(encodings, pull),
      initializationOptions: options,
    });
    this.capabilities = this.result.capabilities;
    this.encoding = this.capabilities.positionEncoding ?? 'utf-16';
    this.notify('initialized', {});
  }

  request(method, params) {
    return fromServer(this.child, this.connection.sendRequest(method, params), method);
  }

  notify(method, params) {
    return this.connection.sendNotification(method, params);
  }

  /** The error that a request is answered with. */
  async refusal(method, params) {
    const error = await this.request(method, params).then(
      (result) => assert.fail(`${method} gave ${JSON.stringify(result)}`),
      (problem) => problem,
    );
    assert.equal(typeof error.code, 'number', `not an answer: ${error}`);
    return error;
  }

  // Files and documents, by uri or by name in the folder.

  uri(name) {
    return name.includes(':') ? name : pathToFileURL(path.join(this.folder, name)).href;
  }

  /** The name of a file in the folder, however its uri is escaped. */
  name(uri) {
    return path.relative(this.folder, fileURLToPath(uri));
  }

  writeFile(name, text) {
    fs.mkdirSync(path.dirname(path.join(this.folder, name)), { recursive: true });
    fs.writeFileSync(path.join(this.folder, name), text);
    this.texts[this.uri(name)] = text;
  }

  removeFile(name) {
    fs.rmSync(path.join(this.folder, name));
    delete this.texts[this.uri(name)];
  }

  /** Says that a file was created (1), changed (2) or deleted (3). */
  watched(name, type) {
    return this.notify('workspace/didChangeWatchedFiles', { changes: [{ uri: this.uri(name), type }] });
  }

  text(name) {
    return this.texts[this.uri(name)];
  }

  open(name, text = this.text(name), version = 1) {
    this.texts[this.uri(name)] = text;
    this.#versions.set(this.uri(name), version);
    return this.notify('textDocument/didOpen', { textDocument: { uri: this.uri(name), languageId: 'gcode', version, text } });
  }

  /** Replaces pieces one after the other, in one notification. Returns the new version. */
  replace(name, ...pairs) {
    let text = this.text(name);
    const contentChanges = [];
    for (const [piece, newText] of pairs) {
      const range = places.rangeOf(text, piece, this.encoding);
      contentChanges.push({ range, text: newText });
      text = places.applyEdits(text, [{ range, newText }], this.encoding);
    }
    return this.change(name, contentChanges, text);
  }

  replaceAll(name, text) {
    return this.change(name, [{ text }], text);
  }

  /** Sends changes; `text` is what they lead to. Returns the new version. */
  change(name, contentChanges, text) {
    const uri = this.uri(name);
    const version = this.#versions.get(uri) + 1;
    this.#versions.set(uri, version);
    this.texts[uri] = text;
    this.notify('textDocument/didChange', { textDocument: { uri, version }, contentChanges });
    return version;
  }

  closeDocument(name) {
    return this.notify('textDocument/didClose', { textDocument: { uri: this.uri(name) } });
  }

  // Places.

  at(name, piece, into = 0) {
    const text = this.text(name);
    return places.positionOf(text, places.find(text, piece) + into, this.encoding);
  }

  range(name, piece) {
    return places.rangeOf(this.text(name), piece, this.encoding);
  }

  params(name, piece, into = 0, more = {}) {
    return { textDocument: { uri: this.uri(name) }, position: this.at(name, piece, into), ...more };
  }

  document(name, more = {}) {
    return { textDocument: { uri: this.uri(name) }, ...more };
  }

  // Diagnostics.

  /**
   * The last pushed diagnostics of a document's version for which the predicate holds; undefined: of any version.
   * `since`: how many of all that were published do not count.
   */
  waitDiagnostics(name, version, predicate = () => true, since = 0) {
    const uri = this.uri(name);
    const fits = (one) => one.uri === uri && (version === undefined || one.version === version) && predicate(one.diagnostics);
    return fromServer(
      this.child,
      new Promise((resolve) => {
        const look = () => {
          const found = this.published.slice(since).findLast(fits);
          if (found === undefined) return;
          this.#waiting.delete(look);
          resolve(found);
        };
        this.#waiting.add(look);
        look();
      }),
      `diagnostics of ${name}, version ${version} (seen: ${JSON.stringify(this.published.map((one) => [one.uri, one.version, codes(one.diagnostics)]))})`,
    );
  }

  pull(name, previousResultId) {
    return this.request('textDocument/diagnostic', this.document(name, { identifier: 'owlint', previousResultId }));
  }

  async pulled(name) {
    const report = await this.pull(name);
    assert.equal(report.kind, 'full');
    return report.items;
  }

  /** The texts after a workspace edit, by name. */
  afterEdit(edit) {
    const after = places.applyWorkspaceEdit(this.texts, edit, this.encoding);
    return Object.fromEntries(Object.entries(after).map(([uri, text]) => [this.name(uri), text]));
  }

  async close() {
    assert.equal(await this.request('shutdown'), null);
    await this.notify('exit');
    assert.deepEqual(await this.ended(), { status: 0, signal: null }, this.child.complaints);
  }

  ended() {
    return within(this.child.ended, 'the end of the process');
  }
}

export function codes(diagnostics) {
  return diagnostics.map((one) => one.code);
}

/** Definition's three kinds of results as one: where they lead. */
export function locations(result) {
  return [result ?? []].flat().map((one) => ({ uri: one.targetUri ?? one.uri, range: one.targetSelectionRange ?? one.range }));
}

/** A markup content, marked string or plain text as text. */
export function markup(contents) {
  return [contents ?? []].flat().map((one) => one.value ?? one).join('\n');
}
