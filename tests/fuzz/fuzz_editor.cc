// Any text, edited and asked about at any place: the features come back, with places inside the text.
#include <cstdlib>
#include <string>

#include "analyzer/lsp/features.h"

using namespace owlint;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 8) return 0;
  const std::string uri = data[7] % 2 == 0 ? "file:///no-such-folder/p.ngc" : "file:///no-such-folder/p.ini";
  const MemoryFiles none;
  lsp::Workspace workspace(none);
  workspace.encoding = static_cast<lsp::Encoding>(data[0] % 3);
  workspace.open(uri, std::string(reinterpret_cast<const char*>(data + 8), size - 8), 1);
  const lsp::Json at{{"line", data[1]}, {"character", data[2]}};
  const lsp::Json to{{"line", data[1] + data[3] % 3}, {"character", data[4]}};
  lsp::Document& document = *workspace.find_open(uri);
  document.change(
      {{"range", {{"start", at}, {"end", to}}}, {"text", std::string(data[5] % 4, static_cast<char>(data[6]))}});
  if (document.lines().count() != lsp::Lines(document.text()).count()) std::abort();
  const lsp::Json params{{"textDocument", {{"uri", uri}}},
                         {"position", at},
                         {"positions", {at}},
                         {"range", {{"start", at}, {"end", to}}},
                         {"newName", "o7"}};
  for (const auto feature : {lsp::definition,
                             lsp::references,
                             lsp::document_highlight,
                             lsp::prepare_rename,
                             lsp::rename,
                             lsp::document_symbol,
                             lsp::document_link,
                             lsp::code_lens,
                             lsp::folding_range,
                             lsp::selection_range,
                             lsp::prepare_call_hierarchy,
                             lsp::completion,
                             lsp::hover,
                             lsp::signature_help,
                             lsp::inlay_hint,
                             lsp::semantic_tokens_full,
                             lsp::semantic_tokens_range,
                             lsp::formatting,
                             lsp::on_type_formatting,
                             lsp::ini_hover,
                             lsp::ini_completion,
                             lsp::ini_definition,
                             lsp::ini_references,
                             lsp::ini_document_link,
                             lsp::ini_document_symbol}) {
    try {
      feature(workspace, params).dump(-1, ' ', false, lsp::Json::error_handler_t::replace);
    } catch (const lsp::ResponseError&) {
      // refused, as it may be
    }
  }
  return 0;
}
