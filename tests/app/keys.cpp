#include "app/keys.h"

#include <gtest/gtest.h>

#include <set>

#include "display/maps.h"

namespace brewster {
namespace {

TEST(Keys, EveryChordStandsOnceAndIsSpelledAsEventsSpellIt) {
    std::set<std::string_view> chords;
    for (const KeyBinding& row : key_table()) {
        EXPECT_TRUE(chords.insert(row.chord).second) << row.chord;
        EXPECT_EQ(binding_of(row.chord), &row);
        InputEvent event;
        std::string rest(row.chord);
        const auto take = [&](const std::string& modifier) {
            const bool there = rest.starts_with(modifier);
            if (there) rest.erase(0, modifier.size());
            return there;
        };
        event.control = take("Ctrl+");
        event.alt = take("Alt+");
        event.shift = take("Shift+");
        event.key = rest;
        EXPECT_EQ(chord_of(event), row.chord);
        EXPECT_FALSE(row.group.empty());
    }
}

TEST(Keys, MapKeysShowTheMapTheyName) {
    const auto shown = [](const char* chord) {
        const KeyBinding* row = binding_of(chord);
        return row && row->action == Action::map ? map_descriptions.at(static_cast<std::size_t>(row->argument)).map
                                                 : Map::bins;
    };
    EXPECT_EQ(shown("1"), Map::radiance);
    EXPECT_EQ(shown("4"), Map::s3);
    EXPECT_EQ(shown("6"), Map::dolp);
    EXPECT_EQ(shown("7"), Map::aolp);
    EXPECT_EQ(shown("9"), Map::type);
    EXPECT_EQ(shown("0"), Map::error);
    EXPECT_EQ(binding_of("B")->argument, static_cast<int>(Map::bins));
}

TEST(Keys, WhatIsSwitchedIsSwitchedOnceHoweverLongItsKeyIsHeld) {
    for (const char* chord : {",", "Shift+.", "E", "Shift+E"}) EXPECT_TRUE(repeats(binding_of(chord)->action)) << chord;
    for (const char* chord : {"A", "P", "V", "Tab", "Space", "Ctrl+Z", "Ctrl+R", "F12"})
        EXPECT_FALSE(repeats(binding_of(chord)->action)) << chord;
}

TEST(Keys, OnlyChangesOfTheSceneCostPhotons) {
    for (const KeyBinding& row : key_table()) {
        const bool scene = row.action == Action::undo || row.action == Action::redo || row.action == Action::restart;
        EXPECT_EQ(row.effect == Effect::retrace, scene) << row.chord;
    }
    EXPECT_EQ(binding_of("Ctrl+P"), nullptr);
}

}  // namespace
}  // namespace brewster
