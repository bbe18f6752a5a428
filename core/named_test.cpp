#include "core/named.h"

#include <gmock/gmock.h>

#include <array>

#include "core/test_folder.h"

namespace plumb {
namespace {

struct Fruit {
    std::string id;
    int price;
};
const std::vector<Fruit> fruit = {{"apple", 1}, {"pear", 2}, {"plum", 3}};

TEST(FindNamed, GivesTheElementOfTheList) {
    EXPECT_EQ(&find_named(fruit, "pear", "fruit"), &fruit[1]);
}

TEST(FindNamed, NamesTheNearestOrAllThatThereAre) {
    EXPECT_EQ(error_of([] { (void)find_named(fruit, "plumb", "fruit"); }),
              "unknown fruit 'plumb'; did you mean 'plum'?");
    EXPECT_EQ(error_of([] { (void)find_named(fruit, "watermelon", "fruit"); }),
              "unknown fruit 'watermelon'; known: apple, pear, plum");
}

TEST(FindNamed, AsksAnyFunctionForTheName) {
    const std::array numbers{1, 2};
    const auto word = [](int n) { return std::string(n == 1 ? "one" : "two"); };
    EXPECT_EQ(find_named(numbers, "two", "number", word), 2);
    const std::vector<std::string> names{"R", "G"};
    EXPECT_EQ(find_named(names, "G", "channel", std::identity{}), "G");
    EXPECT_THROW((void)find_named(names, "alpha", "channel", std::identity{}), Error);
}

}  // namespace
}  // namespace plumb
