// The VS Code side of owlint: starts `owlint lsp` and starts it anew when the settings change. All that is known of
// G-code is known by the server.
import { execFile } from "node:child_process";
import { promisify } from "node:util";
import { commands, type ExtensionContext, window, workspace } from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

let client: LanguageClient | undefined;
// Starts and stops wait for one another: two settings may change at once.
let last: Promise<void> = Promise.resolve();

export function activate(context: ExtensionContext): Promise<void> {
  context.subscriptions.push(
    commands.registerCommand("owlint.restart", restart),
    workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("owlint.path") || event.affectsConfiguration("owlint.arguments")) void restart();
    }),
  );
  return restart();
}

export function deactivate(): Promise<void> {
  return inTurn(stop);
}

function restart(): Promise<void> {
  return inTurn(async () => {
    await stop();
    await start();
  });
}

function inTurn(step: () => Promise<void>): Promise<void> {
  last = last.then(step).catch((error: unknown) => void window.showErrorMessage(`owlint: ${text(error)}`));
  return last;
}

async function start(): Promise<void> {
  const settings = workspace.getConfiguration("owlint");
  const command = settings.get<string>("path", "owlint");
  // Asked for its version first: what the client says of a program that does not start helps nobody.
  try {
    await promisify(execFile)(command, ["--version"]);
  } catch (error) {
    void complain(command, error);
    return;
  }
  // Without `transport`: with it the client would add `--stdio`.
  const server = { command, args: ["lsp", ...settings.get<string[]>("arguments", [])] };
  client = new LanguageClient("owlint", "owlint", server, {
    documentSelector: [
      { language: "linuxcnc", scheme: "file" },
      { language: "linuxcnc", scheme: "untitled" },
    ],
  });
  await client.start();
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  // dispose() also takes a client that did not start, where stop() throws.
  await running?.dispose();
}

async function complain(command: string, error: unknown): Promise<void> {
  const missing = (error as NodeJS.ErrnoException).code === "ENOENT";
  const problem = missing ? `the program \`${command}\` was not found` : `\`${command} --version\` failed: ${text(error)}`;
  const button = "Open the setting";
  const chosen = await window.showErrorMessage(`owlint: ${problem}. Install owlint, or say in owlint.path where it is.`, button);
  if (chosen === button) await commands.executeCommand("workbench.action.openSettings", "owlint.path");
}

function text(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
