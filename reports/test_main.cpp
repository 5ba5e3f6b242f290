#define BOOST_TEST_MODULE porowave_reports
#include <boost/test/unit_test.hpp>
