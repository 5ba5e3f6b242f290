#define BOOST_TEST_MODULE porowave_verification
#include <boost/test/unit_test.hpp>
