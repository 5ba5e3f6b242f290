#define BOOST_TEST_MODULE porowave_reference
#include <boost/test/unit_test.hpp>
