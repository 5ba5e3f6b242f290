#include "verification/adapters/adapter.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(adapter)

using namespace porowave;
using namespace porowave::verification;
namespace fs = std::filesystem;

namespace {

std::optional<Adapter> read(const std::string& text, const std::string& path = "study.toml") {
  return read_adapter(TomlDocument::parse(text, path));
}

void check_refused(const std::string& table, const std::string& expected) {
  std::string message;
  try {
    read("[adapter]\n" + table);
  } catch (const InputError& error) {
    message = error.what();
  }
  BOOST_TEST(message.find(expected) == 0U, "<" << message << "> is not <" << expected << ">");
}

/// A folder with a program `solver`, a file `input` and a study.
class Folder {
 public:
  Folder() {
    write("solver", "#!/bin/sh\nexit 0\n");
    write("input", "some");
    fs::permissions(directory_.file("solver"), fs::perms::owner_all);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.file(name), std::ios::binary) << text;
  }
  Adapter adapter(const std::string& table) const {
    return *read("[adapter]\n" + table, directory_.file("study.toml"));
  }
  std::string file(const std::string& name) const { return directory_.file(name); }
  std::string path() const { return directory_.path(); }

 private:
  ScratchDirectory directory_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_table_is_read) {
  const Folder folder;
  const Adapter a = folder.adapter("command = [\"./solver\", \"-x\", \"\"]\ntime_limit = 2.5\n");
  BOOST_TEST((a.command == std::vector<std::string>{"./solver", "-x", ""}));
  BOOST_TEST(a.time_limit == 2.5);
  BOOST_TEST(fs::equivalent(a.directory, folder.path()));
  BOOST_TEST(folder.adapter("command = [\"sh\"]\n").time_limit == 60.0);
  BOOST_TEST(!read("[study]\nname = \"plain\"\n").has_value());
}

BOOST_AUTO_TEST_CASE(the_table_is_written_as_it_is_read) {
  const Folder folder;
  const Adapter a = folder.adapter(R"(command = ["sh", "-c", "a \"b\" \\ $c", "line\nbreak", "σ′"])"
                                   "\ntime_limit = 3\n");
  const Adapter again = *read(a.toml(), folder.file("study.toml"));
  BOOST_TEST((again.command == a.command));
  BOOST_TEST(again.time_limit == a.time_limit);
  BOOST_TEST(again.identity == a.identity);
}

BOOST_AUTO_TEST_CASE(tables_that_cannot_be) {
  const std::string list = "study.toml:2: [adapter] command = ";
  check_refused("", "study.toml: [adapter] command is missing: expected");
  check_refused("command = \"sh\"\n", list);
  check_refused("command = []\n", list);
  check_refused("command = [1]\n", list);
  check_refused("command = [\"sh\", 1.5]\n", list);
  check_refused("command = [\"a\\u0000b\"]\n", list);
  check_refused("command = [\"sh\"]\ntime_limit = 0\n",
                "study.toml:3: [adapter] time_limit = 0: expected a number > 0");
  check_refused("command = [\"sh\"]\ntime_limit = inf\n", "study.toml:3: [adapter] time_limit");
  check_refused("command = [\"sh\"]\ntimelimit = 5\n",
                "study.toml:3: [adapter] timelimit = 5: unkn");
}

BOOST_AUTO_TEST_CASE(programs_that_cannot_be_started) {
  for (const std::string name : {"./no-such-program", "no-such-program", "/", "", "."}) {
    check_refused("command = [\"" + name + "\"]\n", "study.toml:2: [adapter] command = ");
  }
  const Folder folder;  // a file that is no program
  BOOST_CHECK_THROW(folder.adapter("command = [\"./input\"]\n"), InputError);
  // Without a slash it is looked for in PATH only.
  BOOST_CHECK_THROW(folder.adapter("command = [\"solver\"]\n"), InputError);
}

BOOST_AUTO_TEST_CASE(everything_that_decides_the_output_belongs_to_the_identity) {
  const Folder folder;
  const std::string table = "command = [\"./solver\", \"input\", \"-x\"]\n";
  const std::string identity = folder.adapter(table).identity;
  BOOST_TEST(folder.adapter(table).identity == identity);
  BOOST_TEST(folder.adapter(table + "time_limit = 60.0\n").identity == identity);
  BOOST_TEST(folder.adapter(table + "time_limit = 61.0\n").identity != identity);
  BOOST_TEST(folder.adapter("command = [\"./solver\", \"input\", \"-y\"]\n").identity != identity);
  BOOST_TEST(folder.adapter("command = [\"./solver\", \"input -x\"]\n").identity != identity);
  folder.write("input", "other");
  const std::string other_input = folder.adapter(table).identity;
  BOOST_TEST(other_input != identity);
  folder.write("solver", "#!/bin/sh\nexit 1\n");
  BOOST_TEST(folder.adapter(table).identity != other_input);
  folder.write("solver", "#!/bin/sh\nexit 0\n");
  folder.write("input", "some");
  BOOST_TEST(folder.adapter(table).identity == identity);
}

BOOST_AUTO_TEST_SUITE_END()
