// A report's page in a browser, as its reader uses it. Without chromium there is nothing to test;
// CTest then shows the test as skipped.

#include <boost/test/unit_test.hpp>

#include "reports/report/report_fixtures.hpp"
#include "reports/test_program.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(program_report_page)

using namespace porowave::tests;
using namespace porowave::reports::report_fixtures;
using porowave::reports::ProcessResult;
using porowave::reports::run_process;
using porowave::verification::Store;

namespace {

const TestDirectory& report() {
  static const TestDirectory folder;
  return folder;
}

/// Opens a page of the report; the options come before its address.
ProcessResult browse(const std::string& page, std::vector<std::string> options) {
  std::vector<std::string> command = {"chromium",
                                      "--headless",
                                      "--no-sandbox",
                                      "--disable-gpu",
                                      "--enable-logging=stderr",
                                      "--v=0",
                                      "--host-resolver-rules=MAP * ~NOTFOUND",
                                      "--user-data-dir=" + (report() / "profile").string()};
  command.insert(command.end(), options.begin(), options.end());
  command.push_back("file://" + (report() / page).string());
  return run_process(command, report().path());
}

bool has_browser() {
  if (run_process({"sh", "-c", "command -v chromium"}, ".").exit_code == 0) return true;
  BOOST_TEST_MESSAGE("no chromium: nothing to test");
  return false;
}

/// The report of a study with nasty names, one broken case, a study of 250 groups, and one of cases
/// that can be run again.
void make_report() {
  auto rows = full_study(nasty_name());
  rows[0] = broken(rows[0]);
  for (int i = 0; i < 250; ++i) {
    rows.push_back(row({"bspline1", 1.0 + 0.001 * i}, 0.1 + i, "wide"));
  }
  for (const int elements : {25, 50}) {
    rows.push_back(runnable_row(elements, 5.0 / elements, "kernel = \"bspline2\"", 0.5, "x runs"));
  }
  Store::create_or_open((report() / "results").string()).add(rows);
  const auto result = run_porowave({"report", "results", "--output", "."}, report().path());
  BOOST_REQUIRE_MESSAGE(result.exit_code == 0, result.errors);
}

/// The page with a script behind it that writes what it finds into <pre id="outcome">.
void make_test_page(const std::string& steps) {
  write_text(report() / "test.html", text_of(report() / "index.html") + R"html(<script>
addEventListener('load', () => {
  const lines = [];
  const check = (name, right) => lines.push((right ? 'right: ' : 'WRONG: ') + name);
  const one = (query, within) => (within || document).querySelector(query);
  const all = (query, within) => [...(within || document).querySelectorAll(query)];
  try {
)html" + steps + R"html(
  } catch (error) {
    check(String(error), false);
  }
  const outcome = document.createElement('pre');
  outcome.id = 'outcome';
  outcome.textContent = lines.join('\n') + '\nend';
  document.body.append(outcome);
});
</script>)html");
}

/// That the browser ran all steps, found all right, and complained of nothing.
void check_steps(const std::string& steps, std::vector<std::string> options = {}) {
  make_test_page(steps);
  options.insert(options.begin(), {"--virtual-time-budget=10000", "--dump-dom"});
  const auto result = browse("test.html", options);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(!contains(result.errors, "CONSOLE"), result.errors);
  const auto at = result.output.find("<pre id=\"outcome\">");
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, "the steps did not end: " + result.errors);
  const std::string outcome = result.output.substr(at, result.output.find("</pre>", at) - at);
  BOOST_TEST(contains(outcome, "right: "), outcome);
  BOOST_TEST(contains(outcome, "\nend"), outcome);
  BOOST_TEST(!contains(outcome, "WRONG"), outcome);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_reader_sorts_filters_and_opens_a_case) {
  if (!has_browser()) return;
  make_report();
  check_steps(R"js(
    const box = one('#table_groups_1');
    const rows = () => all('tbody > tr', box);
    check('four groups', rows().length === 4);
    const column = all('thead th', box).findIndex(head => head.textContent === 'effective stress');
    const sort = one('button', all('thead th', box)[column]);
    const values = () => rows().map(row => parseFloat(row.cells[column].textContent));
    sort.click();
    check('ascending', values().every((v, i, list) => i === 0 || list[i - 1] <= v));
    check('said so', one('th[aria-sort=ascending]', box) === sort.parentNode);
    const upwards = values();
    sort.click();
    check('descending', JSON.stringify(values()) === JSON.stringify(upwards.reverse()));
    check('different values', new Set(upwards).size === 4);
    const filter = one('input', box);
    filter.value = 'BSPLINE2 3.0';
    filter.dispatchEvent(new Event('input'));
    check('one group left', rows().length === 1 && rows()[0].textContent.includes('bspline2'));
    check('count', one('[role=status]', box).textContent.startsWith('1 of 4 rows'));
    one('button', rows()[0]).click();
    const cases = all('tr.cases tbody tr', box);
    check('its twelve cases', cases.length === 12);
    const opener = one('button', cases[5]);
    const id = opener.getAttribute('aria-label').split(' ').pop();
    opener.click();
    const dialog = one('dialog');
    check('a dialog', dialog.open);
    const texts = all('pre', dialog).map(pre => pre.textContent);
    check('its command', texts[0] === 'porowave sweep STUDY.toml --store results --case ' + id);
    check('its specification', texts[1].includes('kernel = "bspline2"') &&
      texts[1].includes('elements = ' + cases[5].cells[1].textContent + '\n') &&
      texts[1].includes('seed = ' + cases[5].cells[2].textContent + '\n'));
    check('its address', location.hash === '#case-' + id);
    one('button', dialog).click();
    check('closed', !dialog.open);
    const form = one('#find');
    form.elements.id.value = id.slice(0, 12);
    form.requestSubmit();
    check('found by its id', dialog.open && one('h2', dialog).textContent === 'Case ' + id);
    check('no element of a name', one('main b') === null);
    const runs = all('#runs figure');
    check('figures of runs: ' + runs.length, runs.length === 4);
    check('with texts', runs.every(figure => one('img', figure).alt.length > 80 &&
      one('figcaption', figure).textContent.length > 80));
    check('what could not be run is said', one('#runs').textContent.includes('cannot run it'));
    check('its names are texts', one('#runs b') === null);
    check('name in full', one('h1').textContent.includes('</scr' + 'ipt> \\n {x_1^2}'));
    check('nothing from a network', performance.getEntriesByType('resource')
      .every(entry => entry.name.startsWith('data:') || entry.name.startsWith('file:')));
    check('pictures', all('img').every(image => image.complete && image.naturalWidth > 0 && image.alt));
  )js");
}

BOOST_AUTO_TEST_CASE(many_groups_come_in_parts) {
  if (!has_browser()) return;
  check_steps(R"js(
    const box = one('#table_groups_2');
    check('some', all('tbody > tr', box).length === 200);
    const more = all('button', box).find(button => button.textContent === 'Show more rows');
    more.click();
    check('all', all('tbody > tr', box).length === 250);
    check('no more', more.hidden);
  )js");
}

BOOST_AUTO_TEST_CASE(a_phone_scrolls_only_what_is_wide) {
  if (!has_browser()) return;
  check_steps(R"js(
    check('narrow', innerWidth <= 600);
    check('page fits: ' + document.documentElement.scrollWidth + ' in ' + innerWidth,
      document.documentElement.scrollWidth <= innerWidth);
    const wide = all('body *').filter(e => !e.parentNode.closest('.scroll, dialog') &&
      e.getBoundingClientRect().right > innerWidth + 1).map(e => e.tagName + '.' + e.className);
    check('nothing sticks out: ' + wide.join(' '), wide.length === 0);
    check('table scrolls', all('.table .scroll').some(box => box.scrollWidth > box.clientWidth));
  )js",
              {"--window-size=400,800"});
}

BOOST_AUTO_TEST_CASE(it_prints) {
  if (!has_browser()) return;
  const auto result = browse("index.html", {"--print-to-pdf=" + (report() / "page.pdf").string()});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(text_of(report() / "page.pdf").rfind("%PDF", 0) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
