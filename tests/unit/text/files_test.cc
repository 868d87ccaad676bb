// Files on disk and files in memory answer alike; and paths as text are what std::filesystem makes of them.
#include "analyzer/text/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/text/memory_files.h"
#include "analyzer/text/paths.h"
#include "support/files.h"

using namespace owlint;
using namespace owlint::test;

namespace {

namespace fs = std::filesystem;

/// The same files, made in either way, below a folder.
void make_in_memory(MemoryFiles& files, const std::string& folder) {
  files.add_file(folder + "/p.ngc", "M2\n");
  files.add_file(folder + "/empty.ngc", "");
  files.add_file(folder + "/subs/s.ngc", "o<s> sub\no<s> endsub\n");
  files.add_file(folder + "/subs/deep/d.ngc", "M30\n");
  files.add_folder(folder + "/nothing");
  files.add_link(folder + "/link.ngc", "p.ngc");
  files.add_link(folder + "/other", "subs/deep");
  files.add_link(folder + "/subs/absolute.ngc", folder + "/other/../s.ngc");
  files.add_link(folder + "/loop.ngc", "back.ngc");
  files.add_link(folder + "/back.ngc", "loop.ngc");
  files.add_link(folder + "/broken.ngc", "nowhere.ngc");
  files.add_link(folder + "/nothing/up", "..");
  files.add_other(folder + "/fifo.ngc");
  files.add_file(folder + "/secret.ngc", "M2\n");
  files.forbid(folder + "/secret.ngc");
  files.add_file(folder + "/closed/in.ngc", "M2\n");
  files.forbid(folder + "/closed");
}

void make_on_disk(const Scratch& scratch) {
  const std::string& folder = scratch.path();
  scratch.write("p.ngc", "M2\n");
  scratch.write("empty.ngc", "");
  scratch.write("subs/s.ngc", "o<s> sub\no<s> endsub\n");
  scratch.write("subs/deep/d.ngc", "M30\n");
  fs::create_directory(folder + "/nothing");
  fs::create_symlink("p.ngc", folder + "/link.ngc");
  fs::create_symlink("subs/deep", folder + "/other");
  fs::create_symlink(folder + "/other/../s.ngc", folder + "/subs/absolute.ngc");
  fs::create_symlink("back.ngc", folder + "/loop.ngc");
  fs::create_symlink("loop.ngc", folder + "/back.ngc");
  fs::create_symlink("nowhere.ngc", folder + "/broken.ngc");
  fs::create_symlink("..", folder + "/nothing/up");
  REQUIRE(::mkfifo((folder + "/fifo.ngc").c_str(), 0644) == 0);
  ::chmod(scratch.write("secret.ngc", "M2\n").c_str(), 0);
  scratch.write("closed/in.ngc", "M2\n");
  ::chmod((folder + "/closed").c_str(), 0);
  ::chmod(folder.c_str(), 0755);
}

/// Root may read everything: as long as this lives, we are somebody else.
class NotRoot {
 public:
  NotRoot() {
    if (::getuid() != 0) return;
    was_root_ = true;
    REQUIRE(::setresuid(kNobody, kNobody, 0) == 0);
  }
  ~NotRoot() {
    if (was_root_) static_cast<void>(::setresuid(0, 0, 0) == 0);
  }
  NotRoot(const NotRoot&) = delete;
  NotRoot& operator=(const NotRoot&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  bool was_root_ = false;
};

std::string read(const Files& files, const std::string& path) {
  std::string error = "no error";
  const auto source = files.read(path, &error);
  if (source == nullptr) return "(" + error + ")";
  CHECK(source->path() == path);
  return std::string(source->bytes());
}

std::string kind(const Files& files, const std::string& path) {
  static const char* const kNames[] = {"nothing", "file", "folder", "link", "other"};
  return kNames[static_cast<size_t>(files.info(path).kind)];
}

std::string list(const Files& files, const std::string& folder) {
  static const char kMarks[] = {'?', ' ', '/', '@', '|'};
  std::string error;
  std::vector<std::string> names;
  for (const FolderEntry& entry : files.list(folder, &error))
    names.push_back(entry.name + kMarks[static_cast<size_t>(entry.kind)]);
  std::ranges::sort(names);
  std::string all = error.empty() ? "" : "(" + error + ")";
  for (const std::string& name : names) all += name + " ";
  return all;
}

void check_files(const Files& files, const std::string& folder) {
  const auto at = [&](const char* name) { return folder + "/" + name; };
  CHECK(read(files, at("p.ngc")) == "M2\n");
  CHECK(read(files, at("empty.ngc")).empty());
  CHECK(read(files, at("subs/./deep/../s.ngc")) == "o<s> sub\no<s> endsub\n");
  CHECK(read(files, at("none.ngc")) == "(No such file or directory)");
  CHECK(read(files, at("none/p.ngc")) == "(No such file or directory)");
  CHECK(read(files, at("p.ngc/p.ngc")) == "(Not a directory)");
  CHECK(read(files, at("subs")) == "(is a directory)");
  CHECK(files.info(at("p.ngc")).bytes == 3);

  // Links lead on, a folder's parent is the one of the folder itself, and circles lead nowhere.
  CHECK(read(files, at("link.ngc")) == "M2\n");
  CHECK(read(files, at("other/d.ngc")) == "M30\n");
  CHECK(read(files, at("subs/absolute.ngc")) == "o<s> sub\no<s> endsub\n");
  CHECK(read(files, at("nothing/up/nothing/up/p.ngc")) == "M2\n");
  CHECK(read(files, at("loop.ngc")) == "(Too many levels of symbolic links)");
  CHECK(read(files, at("broken.ngc")) == "(No such file or directory)");
  CHECK(kind(files, at("link.ngc")) == "file");
  CHECK(kind(files, at("other")) == "folder");
  CHECK(kind(files, at("loop.ngc")) == "nothing");
  CHECK(kind(files, at("broken.ngc")) == "nothing");
  CHECK(files.real_path(at("other/../absolute.ngc")) == at("subs/s.ngc"));
  CHECK(files.real_path(at("nothing/up")) == folder);
  CHECK(files.real_path(at("other/none.ngc")) == at("subs/deep/none.ngc"));
  CHECK(files.real_path(at("loop.ngc")) == at("loop.ngc"));

  // A FIFO to which nobody writes is not waited for.
  CHECK(read(files, at("fifo.ngc")) == "(is not a regular file)");
  CHECK(kind(files, at("fifo.ngc")) == "other");

  CHECK(list(files, at("subs")) == "absolute.ngc@ deep/ s.ngc  ");
  CHECK(list(files, at("other/")) == "d.ngc  ");
  CHECK(list(files, at("nothing")) == "up@ ");
  CHECK(list(files, folder) ==
        "back.ngc@ broken.ngc@ closed/ empty.ngc  fifo.ngc| link.ngc@ loop.ngc@ nothing/ other@ p.ngc  secret.ngc  "
        "subs/ ");
  CHECK(list(files, at("none")) == "(No such file or directory)");
  CHECK(list(files, at("p.ngc")) == "(Not a directory)");

  CHECK(files.readable(at("p.ngc")));
  CHECK_FALSE(files.readable(at("none.ngc")));
  {
    const NotRoot somebody;
    CHECK(kind(files, at("secret.ngc")) == "file");
    CHECK_FALSE(files.readable(at("secret.ngc")));
    CHECK(read(files, at("secret.ngc")) == "(Permission denied)");
    CHECK(list(files, at("closed")) == "(Permission denied)");
    CHECK(read(files, at("closed/in.ngc")) == "(Permission denied)");
    CHECK(kind(files, at("closed/in.ngc")) == "nothing");
  }
}

std::string random_path(std::mt19937& random) {
  static const std::vector<std::string> kParts = {"/", "/", "/", ".", "..", "a", "b.ngc", ".x", "c.", "d.e.f"};
  std::string path;
  for (size_t parts = random() % 9; parts > 0; --parts) path += kParts[random() % kParts.size()];
  return path;
}

}  // namespace

TEST_CASE("files on disk", "[text][files]") {
  const Scratch scratch;
  make_on_disk(scratch);
  check_files(disk(), scratch.path());
  ::chmod((scratch.path() + "/closed").c_str(), 0700);
  CHECK(kind(disk(), "/dev/null") == "other");
  CHECK(read(disk(), "/dev/zero") == "(is not a regular file)");
}

TEST_CASE("files in memory", "[text][files]") {
  MemoryFiles files;
  make_in_memory(files, "/shop/programs");
  check_files(files, "/shop/programs");
  CHECK(list(files, "/") == "shop/ ");
  CHECK(files.real_path("/") == "/");
  files.add_file("relative.ngc", "M2\n");
  CHECK(read(files, file_key("relative.ngc")) == "M2\n");
}

TEST_CASE("a large file is mapped", "[text][files]") {
  const Scratch scratch;
  const std::string text(1 << 20, 'x');
  CHECK(read(disk(), scratch.write("large.ngc", text)) == text);
}

TEST_CASE("a stamp is what a file had before it could change unnoticed", "[text][files]") {
  const Scratch scratch;
  CHECK(disk().info(scratch.write("young.ngc", "M2\n")).stamp == 0);  // it may change within the same tick of its time
  CHECK(disk().info("/bin/sh").stamp != 0);
  CHECK(disk().info("/bin/sh").stamp == disk().info("/bin/sh").stamp);
}

TEST_CASE("a text that is not saved stands for the file's bytes only", "[text][files]") {
  MemoryFiles saved;
  saved.add_file("/p.ngc", "M2\n");
  const auto text = Source::own("/q.ngc", "M30\n");
  const UnsavedFiles files(saved, [&](const std::string& path) { return path == text->path() ? text : nullptr; });
  CHECK(read(files, "/p.ngc") == "M2\n");
  CHECK(read(files, "/q.ngc") == "M30\n");
  CHECK(kind(files, "/q.ngc") == "nothing");
  CHECK(list(files, "/") == "p.ngc  ");
}

TEST_CASE("paths are taken apart and put together as std::filesystem does it", "[text][files]") {
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const std::string path = random_path(random);
    const std::string folder = random_path(random);
    INFO("`" << path << "` in `" << folder << "`");
    const bool only_slashes = path.find_first_not_of('/') == std::string::npos;  // libstdc++ leaves them
    CHECK((normal_path(path) == fs::path(path).lexically_normal().string() || only_slashes));
    CHECK(name_of(path) == fs::path(path).filename().string());
    CHECK(ending_of(path) == fs::path(path).extension().string());
    CHECK(stem_of(path) == fs::path(path).stem().string());
    CHECK(joined_path(folder, path) == (fs::path(folder) / path).string());
    const std::string to = normal_path("/" + path + "/x");
    const std::string from = normal_path("/" + folder);
    CHECK(normal_path(from + "/" + relative_path(to, from)) == to);
  }
  CHECK(relative_path("/shop/a/p.ngc", "/shop/b") == "../a/p.ngc");
  CHECK(relative_path("/shop/p.ngc", "/shop/") == "p.ngc");
  CHECK(relative_path("/shop", "/shop") == ".");
  CHECK(normal_path("//") == "/");
}
