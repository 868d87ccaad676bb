#include "analyzer/lsp/server.h"

#include <algorithm>
#include <iostream>
#include <thread>
#include <unordered_map>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/ini_document.h"
#include "analyzer/report/report.h"

namespace owlint::lsp {
namespace {

using Feature = Json (*)(Workspace&, const Json&);

const std::unordered_map<std::string, Feature>& features() {
  static const std::unordered_map<std::string, Feature> all = {
      {"textDocument/diagnostic", document_diagnostic},
      {"workspace/diagnostic", workspace_diagnostic},
      {"textDocument/definition", definition},
      {"textDocument/declaration", definition},
      {"textDocument/references", references},
      {"textDocument/documentHighlight", document_highlight},
      {"textDocument/prepareRename", prepare_rename},
      {"textDocument/rename", rename},
      {"textDocument/documentSymbol", document_symbol},
      {"workspace/symbol", workspace_symbol},
      {"textDocument/documentLink", document_link},
      {"textDocument/codeLens", code_lens},
      {"textDocument/foldingRange", folding_range},
      {"textDocument/selectionRange", selection_range},
      {"textDocument/prepareCallHierarchy", prepare_call_hierarchy},
      {"callHierarchy/incomingCalls", incoming_calls},
      {"callHierarchy/outgoingCalls", outgoing_calls},
      {"textDocument/completion", completion},
      {"textDocument/hover", hover},
      {"textDocument/signatureHelp", signature_help},
      {"textDocument/inlayHint", inlay_hint},
      {"textDocument/semanticTokens/full", semantic_tokens_full},
      {"textDocument/semanticTokens/full/delta", semantic_tokens_delta},
      {"textDocument/semanticTokens/range", semantic_tokens_range},
      {"textDocument/formatting", formatting},
      {"textDocument/rangeFormatting", range_formatting},
      {"textDocument/onTypeFormatting", on_type_formatting},
      {"textDocument/codeAction", code_action},
      {"workspace/executeCommand", execute_command},
  };
  return all;
}

/// What there is for a machine's INI; to other questions about it the answer is `null`.
const std::unordered_map<std::string, Feature>& ini_features() {
  static const std::unordered_map<std::string, Feature> all = {
      {"textDocument/diagnostic", document_diagnostic},
      {"textDocument/definition", ini_definition},
      {"textDocument/declaration", ini_definition},
      {"textDocument/references", ini_references},
      {"textDocument/documentSymbol", ini_document_symbol},
      {"textDocument/documentLink", ini_document_link},
      {"textDocument/completion", ini_completion},
      {"textDocument/hover", ini_hover},
      {"textDocument/codeAction", code_action},
  };
  return all;
}

const char* encoding_name(Encoding encoding) {
  return encoding == Encoding::kUtf8 ? "utf-8" : encoding == Encoding::kUtf32 ? "utf-32" : "utf-16";
}

Json capabilities(Encoding encoding) {
  const Json operations = {
      {"filters",
       Json::array(
           {{{"scheme", "file"}, {"pattern", {{"glob", "**/*.{ngc,nc,tap,cnc,gcode}"}, {"matches", "file"}}}}})}};
  return {
      {"positionEncoding", encoding_name(encoding)},
      {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
      {"diagnosticProvider",
       {{"identifier", "owlint"}, {"interFileDependencies", true}, {"workspaceDiagnostics", true}}},
      {"definitionProvider", true},
      {"declarationProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"documentLinkProvider", {{"resolveProvider", false}}},
      {"codeLensProvider", {{"resolveProvider", false}}},
      {"foldingRangeProvider", true},
      {"selectionRangeProvider", true},
      {"callHierarchyProvider", true},
      {"completionProvider",
       {{"triggerCharacters", {"o", "O", "<", " ", "g", "G", "m", "M", ".", "[", "="}}, {"resolveProvider", false}}},
      {"hoverProvider", true},
      {"signatureHelpProvider", {{"triggerCharacters", {"["}}, {"retriggerCharacters", {"]"}}}},
      {"inlayHintProvider", {{"resolveProvider", false}}},
      {"semanticTokensProvider", {{"legend", semantic_tokens_legend()}, {"range", true}, {"full", {{"delta", true}}}}},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"documentOnTypeFormattingProvider", {{"firstTriggerCharacter", "\n"}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll.owlint"}}, {"resolveProvider", false}}},
      {"executeCommandProvider", {{"commands", {"owlint.explain"}}}},
      {"workspace",
       {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}},
        {"fileOperations", {{"didRename", operations}}}}},
  };
}

/// A value inside nested objects, or null.
Json at_path(const Json& json, std::initializer_list<const char*> path) {
  const Json* at = &json;
  for (const char* key : path) {
    if (!at->is_object() || !at->contains(key)) return nullptr;
    at = &at->at(key);
  }
  return *at;
}

bool is_true(const Json& json) { return json.is_boolean() && json.get<bool>(); }

void read_messages(std::FILE* in, const std::shared_ptr<Inbox>& inbox) {
  std::string problem;
  while (auto body = read_message(in, &problem)) {
    // Cancellations overtake what they cancel.
    const bool may_cancel = body->find("$/cancelRequest") != std::string::npos;
    const Json message = may_cancel ? Json::parse(*body, nullptr, false) : Json();
    const std::lock_guard lock(inbox->mutex);
    if (at_path(message, {"method"}) == "$/cancelRequest") {
      inbox->cancelled.insert(at_path(message, {"params", "id"}).dump());
    } else {
      inbox->waiting.push_back(std::move(*body));
    }
    inbox->arrived.notify_one();
  }
  if (!problem.empty()) std::cerr << "owlint: " << problem << '\n';
  const std::lock_guard lock(inbox->mutex);
  inbox->ended = true;
  inbox->arrived.notify_one();
}

}  // namespace

int Server::run() {
  std::thread(read_messages, in_, inbox_).detach();
  while (state_ != State::kExited) {
    std::string body;
    {
      std::unique_lock lock(inbox_->mutex);
      inbox_->arrived.wait(lock, [this] { return !inbox_->waiting.empty() || inbox_->ended; });
      if (inbox_->waiting.empty()) return 1;  // the client has gone without a word
      body = std::move(inbox_->waiting.front());
      inbox_->waiting.pop_front();
    }
    Json message = Json::parse(body, nullptr, false);
    if (message.is_discarded()) {
      refuse(nullptr, {ErrorCode::kParseError, "the message is not JSON"});
    } else {
      handle(std::move(message));
    }
  }
  return exit_status_;
}

void Server::handle(Json message) {
  if (message.is_array()) return refuse(nullptr, {ErrorCode::kInvalidRequest, "batches are not part of the protocol"});
  if (!message.is_object() || (message.contains("method") && !message.at("method").is_string())) {
    return refuse(nullptr, {ErrorCode::kInvalidRequest, "the message is not a request"});
  }
  if (!message.contains("method")) {
    // An answer to one of our own requests: nothing depends on it. Anything else is no message.
    if (!message.contains("result") && !message.contains("error"))
      refuse(message.value("id", Json()), {ErrorCode::kInvalidRequest, "the message has no method"});
    return;
  }
  const std::string method = message.at("method").get<std::string>();
  const Json params = message.value("params", Json::object());
  if (message.contains("id")) return request(message.at("id"), method, params);
  try {
    notification(method, params);
  } catch (const Json::exception& problem) {
    std::cerr << "owlint: " << method << ": " << problem.what() << '\n';
  } catch (const ResponseError& problem) {
    std::cerr << "owlint: " << method << ": " << problem.message << '\n';
  }
}

void Server::request(const Json& id, const std::string& method, const Json& params) {
  {
    const std::lock_guard lock(inbox_->mutex);
    if (inbox_->cancelled.erase(id.dump()) > 0) return refuse(id, {ErrorCode::kRequestCancelled, "cancelled"});
  }
  try {
    if (state_ == State::kShutDown) throw ResponseError{ErrorCode::kInvalidRequest, "the server is shut down"};
    if (method == "initialize") {
      if (state_ != State::kNew) throw ResponseError{ErrorCode::kInvalidRequest, "the server is already initialized"};
      return answer(id, initialize(params));
    }
    if (state_ == State::kNew) throw ResponseError{ErrorCode::kServerNotInitialized, "the server is not initialized"};
    if (method == "shutdown") {
      state_ = State::kShutDown;
      return answer(id, nullptr);
    }
    const auto feature = features().find(method);
    if (feature == features().end()) throw ResponseError{ErrorCode::kMethodNotFound, "no such method: " + method};
    const Json uri = at_path(params, {"textDocument", "uri"});
    if (!uri.is_string() || !is_ini(path_of_uri(uri))) return answer(id, feature->second(workspace_, params));
    const auto of_ini = ini_features().find(method);
    answer(id, of_ini == ini_features().end() ? Json() : of_ini->second(workspace_, params));
  } catch (const ResponseError& error) {
    refuse(id, error);
  } catch (const Json::exception& error) {
    refuse(id, {ErrorCode::kInvalidParams, error.what()});
  } catch (const std::exception& error) {
    refuse(id, {ErrorCode::kInternalError, error.what()});
  }
}

void Server::notification(const std::string& method, const Json& params) {
  if (method == "exit") {
    exit_status_ = state_ == State::kShutDown ? 0 : 1;
    state_ = State::kExited;
    return;
  }
  if (state_ != State::kInitialized) return;  // the protocol wants them dropped
  if (method == "initialized") return initialized();
  if (method == "textDocument/didOpen") {
    const Json& document = params.at("textDocument");
    workspace_.open(document.at("uri"), document.at("text"), document.value("version", int64_t{0}));
    publish(workspace_.check(document.at("uri")));
  } else if (method == "textDocument/didChange") {
    changed(params);
  } else if (method == "textDocument/didClose") {
    const std::string uri = params.at("textDocument").at("uri");
    workspace_.close(uri);
    if (published_.erase(uri) > 0)
      notify("textDocument/publishDiagnostics", {{"uri", uri}, {"diagnostics", Json::array()}});
    check_all();
  } else if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles" ||
             method == "workspace/didRenameFiles") {
    workspace_.forget_files();
    check_all();
  } else if (method == "workspace/didChangeWorkspaceFolders") {
    for (const Json& folder : params.at("event").at("added")) workspace_.add_folder(folder.at("uri"));
    for (const Json& folder : params.at("event").at("removed")) workspace_.remove_folder(folder.at("uri"));
    workspace_.forget_files();
    check_all();
  } else if (method == "workspace/didChangeConfiguration") {
    const Json settings = params.value("settings", Json::object());
    workspace_.configure(settings.is_object() ? settings.value("owlint", settings) : Json::object());
    check_all();
  }
}

Json Server::initialize(const Json& params) {
  const Json client = params.value("capabilities", Json::object());
  const Json encodings = at_path(client, {"general", "positionEncodings"});
  if (encodings.is_array()) {
    for (const Json& name : encodings) {
      // The first that is known: clients list them by preference. Without any, UTF-16 is the rule.
      if (name == "utf-8") workspace_.encoding = Encoding::kUtf8;
      if (name == "utf-32") workspace_.encoding = Encoding::kUtf32;
      if (name == "utf-8" || name == "utf-16" || name == "utf-32") break;
    }
  }
  pulls_ = at_path(client, {"textDocument", "diagnostic"}).is_object();
  refreshes_ = is_true(at_path(client, {"workspace", "diagnostics", "refreshSupport"}));
  progress_ = is_true(at_path(client, {"window", "workDoneProgress"}));
  watches_ = is_true(at_path(client, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"}));
  const Json operations = at_path(client, {"workspace", "workspaceEdit", "resourceOperations"});
  workspace_.renames_files = operations.is_array() && std::ranges::find(operations, "rename") != operations.end();
  const Json folders = params.value("workspaceFolders", Json());
  if (folders.is_array()) {
    for (const Json& folder : folders) workspace_.add_folder(folder.at("uri"));
  } else if (params.contains("rootUri") && params.at("rootUri").is_string()) {
    workspace_.add_folder(params.at("rootUri"));
  }
  workspace_.configure(params.value("initializationOptions", Json::object()));
  state_ = State::kInitialized;
  return {{"capabilities", capabilities(workspace_.encoding)},
          {"serverInfo", {{"name", kToolName}, {"version", kToolVersion}}}};
}

void Server::initialized() {
  watch_files();
  workspace_.progress = [this](const char* work, size_t done, size_t of) { tell_progress(work, done, of); };
  if (!workspace_.folders().empty()) workspace_.read_all();
}

/// A large workspace takes a while: the client is shown how far it is.
void Server::tell_progress(const std::string& work, size_t done, size_t of) {
  constexpr size_t kEvery = 200;  // files
  if (!progress_ || of < kEvery || (done % kEvery != 0 && done != of)) return;
  const auto tell = [&](Json value) { notify("$/progress", {{"token", work}, {"value", std::move(value)}}); };
  if (done == of) {
    if (in_progress_.erase(work) > 0) tell({{"kind", "end"}});
    return;
  }
  if (in_progress_.insert(work).second) {
    ask("window/workDoneProgress/create", {{"token", work}});
    tell({{"kind", "begin"}, {"title", work}, {"percentage", 0}});
  }
  tell({{"kind", "report"},
        {"message", std::to_string(done) + " of " + std::to_string(of)},
        {"percentage", 100 * done / of}});
}

void Server::watch_files() {
  if (!watches_) return;
  Json watchers = Json::array();
  for (const char* glob :
       {"**/*.{ngc,nc,tap,cnc,gcode,NGC,NC,TAP,CNC,GCODE}", "**/*.{ini,INI,tbl,TBL}", "**/{owlint,.owlint}.toml"})
    watchers.push_back({{"globPattern", glob}});
  ask("client/registerCapability",
      {{"registrations",
        Json::array({{{"id", "owlint-files"},
                      {"method", "workspace/didChangeWatchedFiles"},
                      {"registerOptions", {{"watchers", watchers}}}}})}});
}

void Server::changed(const Json& params) {
  const Json& identifier = params.at("textDocument");
  Document* document = workspace_.find_open(identifier.at("uri"));
  if (document == nullptr) throw ResponseError{ErrorCode::kInvalidParams, "the document is not open"};
  for (const Json& change : params.at("contentChanges")) document->change(change);
  if (identifier.contains("version") && identifier.at("version").is_number())
    document->version = identifier.at("version").get<int64_t>();
  if (!more_changes_wait(document->uri())) publish(workspace_.check(document->uri()));
}

/// Whether the next message changes the same document again: then its diagnostics would be out of date at once.
bool Server::more_changes_wait(const std::string& uri) {
  const std::lock_guard lock(inbox_->mutex);
  if (inbox_->waiting.empty() || inbox_->waiting.front().find("textDocument/didChange") == std::string::npos)
    return false;
  const Json next = Json::parse(inbox_->waiting.front(), nullptr, false);
  return at_path(next, {"method"}) == "textDocument/didChange" &&
      at_path(next, {"params", "textDocument", "uri"}) == uri;
}

/// A client that asks for diagnostics itself would show pushed ones twice.
void Server::publish(const std::vector<std::string>& uris) {
  if (pulls_) return;
  for (const std::string& uri : uris) {
    const Document* document = workspace_.find_open(uri);
    const Checked* checked = workspace_.checked(uri);
    if (document == nullptr || checked == nullptr) continue;
    Json params{{"uri", uri}, {"diagnostics", diagnostics_of(*document, checked->findings)}};
    if (document->version) params["version"] = *document->version;
    published_.insert(uri);
    notify("textDocument/publishDiagnostics", std::move(params));
  }
}

void Server::check_all() {
  std::set<std::string> done;
  for (const Document* document : workspace_.open_documents()) {
    if (!done.contains(document->uri())) {
      for (const std::string& uri : workspace_.check(document->uri())) done.insert(uri);
    }
  }
  publish({done.begin(), done.end()});
  if (refreshes_) ask("workspace/diagnostic/refresh", nullptr);
}

/// A client that does not read any more has gone.
void Server::send(const Json& message) {
  if (!write_message(out_, message)) state_ = State::kExited;
}

void Server::answer(const Json& id, Json result) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Server::refuse(const Json& id, const ResponseError& error) {
  send({{"jsonrpc", "2.0"},
        {"id", id},
        {"error", {{"code", static_cast<int>(error.code)}, {"message", error.message}}}});
}

void Server::notify(const std::string& method, Json params) {
  send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Server::ask(const std::string& method, Json params) {
  Json message{{"jsonrpc", "2.0"}, {"id", "owlint-" + std::to_string(++asked_)}, {"method", method}};
  if (!params.is_null()) message["params"] = std::move(params);
  send(message);
}

}  // namespace owlint::lsp
