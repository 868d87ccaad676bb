// The language server: reads messages, dispatches them and answers. LSP 3.17, "Lifecycle Messages" and
// "General Messages". What the methods do is in a file for each feature, see features.h.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <set>

#include "analyzer/lsp/workspace.h"

namespace owlint::lsp {

/// Messages that have been read and wait, so that work which a cancellation or a later change makes unnecessary is not
/// done. The reading thread may outlive the server: after `exit` it still waits for input.
struct Inbox {
  std::mutex mutex;
  std::condition_variable arrived;
  std::deque<std::string> waiting;
  std::set<std::string> cancelled;
  bool ended = false;
};

class Server {
 public:
  Server(std::FILE* in, std::FILE* out) : in_(in), out_(out) {}

  /// Runs until `exit` or the end of the stream. Returns the exit status: 0 after `shutdown` and `exit`, else 1.
  int run();

 private:
  enum class State : uint8_t { kNew, kInitialized, kShutDown, kExited };

  void handle(Json message);
  void request(const Json& id, const std::string& method, const Json& params);
  void notification(const std::string& method, const Json& params);
  Json initialize(const Json& params);
  void initialized();
  void tell_progress(const std::string& work, size_t done, size_t of);
  void watch_files();
  void changed(const Json& params);
  void publish(const std::vector<std::string>& uris);
  void check_all();
  bool more_changes_wait(const std::string& uri);
  void send(const Json& message);
  void answer(const Json& id, Json result);
  void refuse(const Json& id, const ResponseError& error);
  void notify(const std::string& method, Json params);
  void ask(const std::string& method, Json params);

  std::FILE* in_;
  std::FILE* out_;
  State state_ = State::kNew;
  Workspace workspace_{disk()};
  bool pulls_ = false;      // the client asks for diagnostics itself
  bool refreshes_ = false;  // and can be asked to do so again
  bool progress_ = false;
  std::set<std::string> in_progress_;  // work that the client knows of
  bool watches_ = false;
  int64_t asked_ = 0;  // our own requests
  std::set<std::string> published_;
  int exit_status_ = 1;
  std::shared_ptr<Inbox> inbox_ = std::make_shared<Inbox>();
};

}  // namespace owlint::lsp
