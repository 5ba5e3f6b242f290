#include "reports/output_file.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "reports/test_directory.hpp"

BOOST_AUTO_TEST_SUITE(output_file)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::function<void()>& action) {
  return message_of<EnvironmentError>(action);
}

/// As long as it lives no file can grow, as on a full disk; for root, too.
class NoSpace {
 public:
  NoSpace() {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit none{0, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &none);
  }
  ~NoSpace() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  NoSpace(const NoSpace&) = delete;
  NoSpace& operator=(const NoSpace&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_has_exactly_the_text) {
  const TestDirectory folder;
  const std::string text("a\r\nb\0c\n", 7);
  write_file(folder / "new.csv", text);
  BOOST_TEST(text_of(folder / "new.csv") == text);
  write_file(folder / "new.csv", "short");
  BOOST_TEST(text_of(folder / "new.csv") == "short");
  write_file(folder / "new.csv", "");
  BOOST_TEST(text_of(folder / "new.csv") == "");
  BOOST_TEST(folder.contents() == "new.csv");
}

BOOST_AUTO_TEST_CASE(an_unfinished_file_leaves_nothing) {
  const TestDirectory folder;
  const auto broken = [](std::ostream& out) {
    out << std::string(100000, 'x') << std::flush;
    throw std::runtime_error("half way");
  };
  BOOST_CHECK_THROW(write_file(folder / "points.csv", broken), std::runtime_error);
  BOOST_TEST(folder.contents() == "");
  write_text(folder / "points.csv", "old");
  BOOST_CHECK_THROW(write_file(folder / "points.csv", broken), std::runtime_error);
  BOOST_TEST(folder.contents() == "points.csv");
  BOOST_TEST(text_of(folder / "points.csv") == "old");
}

BOOST_AUTO_TEST_CASE(the_old_file_stays_readable_until_the_new_one_is_complete) {
  const TestDirectory folder;
  write_text(folder / "points.csv", "old");
  write_file(folder / "points.csv", [&](std::ostream& out) {
    out << "new" << std::flush;
    BOOST_TEST(text_of(folder / "points.csv") == "old");
  });
  BOOST_TEST(text_of(folder / "points.csv") == "new");
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_an_error_and_keeps_the_old_file) {
  const TestDirectory folder;
  write_text(folder / "points.csv", "old");
  std::string write_message, probe_message, folder_message;
  {
    const NoSpace full;
    write_message = refusal([&] { write_file(folder / "points.csv", "new"); });
    probe_message = refusal([&] { require_writable(folder / "points.csv"); });
    folder_message = refusal([&] { make_output_directory(folder / "a/b/c"); });
  }
  BOOST_TEST(contains(write_message, (folder / "points.csv").string() + ": cannot be written: "));
  BOOST_TEST(contains(probe_message, (folder / "points.csv").string() + ": cannot be written: "));
  BOOST_TEST(contains(folder_message, (folder / "a/b/c").string() + ": cannot be written: "));
  BOOST_TEST(folder.contents() == "points.csv");
  BOOST_TEST(text_of(folder / "points.csv") == "old");
  if (fs::exists("/dev/full")) {
    BOOST_TEST(contains(refusal([] { write_file("/dev/full", "text"); }), "/dev/full"));
  }
}

BOOST_AUTO_TEST_CASE(a_place_where_no_file_can_be_is_named) {
  const TestDirectory folder;
  write_text(folder / "file", "");
  fs::create_directory(folder / "directory");
  fs::create_symlink("loop", folder / "loop");
  for (const std::string& name :
       {"file/points.csv"s, "missing/points.csv"s, "directory"s, "loop"s, std::string(300, 'n')}) {
    const fs::path path = folder / name;
    BOOST_TEST_CONTEXT(path) {
      BOOST_TEST(contains(refusal([&] { write_file(path, "text"); }),
                          path.string() + ": cannot be written: "));
      if (name == "loop") continue;  // what is no regular file is tried only when it is written
      BOOST_TEST(contains(refusal([&] { require_writable(path); }),
                          path.string() + ": cannot be written: "));
    }
  }
  BOOST_TEST(folder.contents() == "directory file loop");
}

BOOST_AUTO_TEST_CASE(the_check_before_long_work_changes_nothing) {
  const TestDirectory folder;
  require_writable(folder / "points.csv");
  BOOST_TEST(folder.contents() == "");
  write_text(folder / "points.csv", "old");
  require_writable(folder / "points.csv");
  BOOST_TEST(folder.contents() == "points.csv");
  BOOST_TEST(text_of(folder / "points.csv") == "old");
}

BOOST_AUTO_TEST_CASE(a_link_goes_on_leading_to_its_file) {
  const TestDirectory folder;
  write_text(folder / "file.csv", "old");
  fs::create_symlink("file.csv", folder / "link.csv");
  write_file(folder / "link.csv", "new");
  BOOST_TEST(fs::is_symlink(folder / "link.csv"));
  BOOST_TEST(text_of(folder / "file.csv") == "new");
  BOOST_TEST(folder.contents() == "file.csv link.csv");
}

BOOST_AUTO_TEST_CASE(directories_are_made_or_left_alone) {
  const TestDirectory folder;
  make_output_directory(folder / "a/b");
  BOOST_TEST(folder.contents() == "a a/b");
  make_output_directory(folder / "a/b");
  BOOST_TEST(folder.contents() == "a a/b");
  write_text(folder / "file", "");
  for (const std::string& name : {"file"s, "file/below"s, "new/" + std::string(300, 'n')}) {
    const fs::path path = folder / name;
    BOOST_TEST_CONTEXT(path) {
      BOOST_TEST(contains(refusal([&] { make_output_directory(path); }),
                          path.string() + ": cannot be written: "));
    }
  }
  BOOST_TEST(folder.contents() == "a a/b file");
}

BOOST_AUTO_TEST_CASE(missing_permission_is_an_error) {
  if (geteuid() == 0) {
    BOOST_TEST_MESSAGE("root may write everywhere: nothing to test");
    return;
  }
  const TestDirectory folder;
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  BOOST_TEST(contains(refusal([&] { require_writable(folder / "closed/x"); }), "closed/x"));
  BOOST_TEST(contains(refusal([&] { write_file(folder / "closed/x", ""); }), "closed/x"));
  BOOST_TEST(contains(refusal([&] { make_output_directory(folder / "closed/x"); }), "closed/x"));
  BOOST_TEST(contains(refusal([&] { make_output_directory(folder / "closed"); }), "closed"));
  fs::permissions(folder / "closed", fs::perms::none);
  BOOST_TEST(contains(refusal([&] { write_file(folder / "closed/x", ""); }), "closed/x"));
  fs::permissions(folder / "closed", fs::perms::owner_all);
  BOOST_TEST(folder.contents() == "closed");
}

BOOST_AUTO_TEST_SUITE_END()
