// The VS Code side of owlint: starts `owlint lsp`, restarts it when its settings change, and shows the
// rules' pages. Everything about G-code and INIs is in the server.
import { execFile } from "node:child_process";
import { promisify } from "node:util";
import { commands, type ExtensionContext, type OutputChannel, Uri, window, workspace } from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

// The client handles `owlint.trace.server` itself; no restart is needed.
const settingsOfServer = ["path", "arguments", "ini", "linuxcnc"].map((name) => `owlint.${name}`);
let client: LanguageClient | undefined;
let output: OutputChannel;
// Starts and stops wait for one another: settings may change while the server starts.
let last: Promise<void> = Promise.resolve();
const pages = new Map<string, string>(); // Markdown, by the path of the Uri under which it is shown

export function activate(context: ExtensionContext): Promise<void> {
  output = window.createOutputChannel("owlint");
  context.subscriptions.push(
    output,
    commands.registerCommand("owlint.restart", restart),
    workspace.registerTextDocumentContentProvider("owlint", { provideTextDocumentContent: (uri) => pages.get(uri.path) }),
    workspace.onDidChangeConfiguration((event) => {
      if (settingsOfServer.some((name) => event.affectsConfiguration(name))) void restart();
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
  // First ask for the version: the client's own message about a missing program helps nobody.
  try {
    await promisify(execFile)(command, ["--version"]);
  } catch (error) {
    void complain(command, error);
    return;
  }
  // Without `transport`: with it the client would add an argument.
  const server = { command, args: ["lsp", ...settings.get<string[]>("arguments", [])] };
  client = new LanguageClient("owlint", "owlint", server, {
    documentSelector: [
      { language: "linuxcnc", scheme: "file" },
      { language: "linuxcnc", scheme: "untitled" },
      { language: "ini", scheme: "file", pattern: "**/*.ini" },
    ],
    initializationOptions: { ...settings, images: true },  // VS Code shows images in hovers
    outputChannel: output,
    middleware: {
      async executeCommand(name, args, next) {
        const page: unknown = await next(name, args);
        if (name === "owlint.explain" && typeof page === "string") await show(`${args[0]}.md`, page);
        return page;
      },
    },
  });
  // The client reports itself if the server does not start.
  await client.start().catch(() => undefined);
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  // A client whose server did not start, or has ended, cannot be stopped.
  if (running?.needsStop()) await running.dispose();
}

async function show(path: string, page: string): Promise<void> {
  pages.set(path, page);
  await commands.executeCommand("markdown.showPreviewToSide", Uri.from({ scheme: "owlint", path }));
}

async function complain(command: string, error: unknown): Promise<void> {
  const missing = (error as NodeJS.ErrnoException).code === "ENOENT";
  const problem = missing ? `the program \`${command}\` was not found` : `\`${command} --version\` failed: ${text(error)}`;
  const button = "Open the setting";
  const chosen = await window.showErrorMessage(`owlint: ${problem}. Install owlint, or set owlint.path.`, button);
  if (chosen === button) await commands.executeCommand("workbench.action.openSettings", "owlint.path");
}

function text(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
