// A peer that writes bytes as it is told, for what a well-behaved client library would never send.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import path from 'node:path';

const here = path.dirname(fileURLToPath(import.meta.url));
const named = process.env.OWLINT ?? path.resolve(here, '../../build/release/owlint');
// Absolute, since the server is started in folders of its own; a mere name is looked for in PATH.
export const program = named.includes('/') ? path.resolve(named) : named;

/** Everything that is waited for ends: with a value, or after this time with a failure. */
export const patience = 30_000;

export function within(promise, what) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`${what}: nothing within ${patience / 1000} s`)), patience);
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** The same for what a server owes: it is not waited for once the server has ended. */
export function fromServer(child, promise, what) {
  const over = child.ended.then(({ status, signal }) => Promise.reject(new Error(`${what}: the server has ended (${signal ?? status}) ${child.complaints}`)));
  return within(Promise.race([promise, over]), what);
}

export function startProgram(t, folder) {
  const child = spawn(program, ['lsp'], { cwd: folder, stdio: ['pipe', 'pipe', 'pipe'] });
  child.complaints = '';
  child.stderr.setEncoding('utf8').on('data', (text) => (child.complaints += text));
  child.stdin.on('error', () => {}); // a server that has ended no longer reads: its exit status tells
  child.ended = new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (status, signal) => resolve({ status, signal }));
  });
  child.ended.catch(() => {});
  t.after(() => child.kill('SIGKILL'));
  return child;
}

export function frame(message, headers = '') {
  const body = typeof message === 'string' ? message : JSON.stringify({ jsonrpc: '2.0', ...message });
  return `Content-Length: ${Buffer.byteLength(body)}\r\n${headers}\r\n${body}`;
}

export const initialize = { id: 'first', method: 'initialize', params: { processId: null, rootUri: null, capabilities: {} } };
export const initialized = { method: 'initialized', params: {} };

export class RawPeer {
  received = [];
  #bytes = Buffer.alloc(0);
  #waiting = new Set();

  constructor(t) {
    this.child = startProgram(t);
    this.child.stdout.on('data', (bytes) => this.#take(bytes));
  }

  write(bytes) {
    this.child.stdin.write(bytes);
  }

  send(message) {
    this.write(frame(message));
  }

  /** The first message, also of those that came before, for which the predicate holds. */
  message(predicate, what) {
    return fromServer(
      this.child,
      new Promise((resolve) => {
        const look = () => {
          const found = this.received.find(predicate);
          if (found === undefined) return;
          this.#waiting.delete(look);
          resolve(found);
        };
        this.#waiting.add(look);
        look();
      }),
      what,
    );
  }

  answer(id) {
    return this.message((message) => message.id === id && message.method === undefined, `the answer to ${JSON.stringify(id)}`);
  }

  async start() {
    this.send(initialize);
    const answer = await this.answer('first');
    this.send(initialized);
    return answer.result;
  }

  /** The server still answers, and ends as it should. */
  async finish() {
    this.send({ id: 'last', method: 'shutdown' });
    assert.equal((await this.answer('last')).result, null);
    this.send({ method: 'exit' });
    assert.deepEqual(await this.end(), { status: 0, signal: null });
  }

  end() {
    return within(this.child.ended, 'the end of the process');
  }

  #take(bytes) {
    this.#bytes = Buffer.concat([this.#bytes, bytes]);
    for (;;) {
      const blank = this.#bytes.indexOf('\r\n\r\n');
      if (blank < 0) return;
      const header = this.#bytes.subarray(0, blank).toString('latin1');
      const length = Number(/^Content-Length: (\d+)$/m.exec(header.replaceAll('\r', ''))?.[1]);
      assert.ok(Number.isInteger(length), `not a header: ${header}`);
      if (this.#bytes.length < blank + 4 + length) return;
      this.received.push(JSON.parse(this.#bytes.subarray(blank + 4, blank + 4 + length).toString('utf8')));
      this.#bytes = this.#bytes.subarray(blank + 4 + length);
      for (const look of [...this.#waiting]) look();
    }
  }
}
