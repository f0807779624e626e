#include "phrase_words.hpp"

#include <map>
#include <string>

namespace deixis::motion {

namespace {

struct Entry {
    std::string_view words;  ///< with blanks between
    WordGestures gestures;
};

// Gestured are spatial and deictic words, sizes, amounts; pronouns hardly and verbs of thinking not (Kok
// 2017). The speaker prefers metaphors: of sizes, ways and changes it shows the idea more often than the
// picture. The shares are choices.
constexpr double spatial = 0.9, concrete = 0.8, abstract = 0.6, pronoun = 0.08;

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        {"left", {spatial, {{to_left, 0.8}, {"here_and_there", 0.2}}}},
        {"right", {spatial, {{to_right, 0.8}, {"here_and_there", 0.2}}}},
        {"up above upstairs top upper", {spatial, {{"rising", 0.4}, {"point_up", 0.4}, {"progress", 0.2}}}},
        {"down below under bottom downstairs low floor", {spatial, {{"point_down", 0.5}, {"falling", 0.5}}}},
        {"here this these", {spatial, {{"present", 0.6}, {"point_down", 0.4}}}},
        {"there that those", {abstract, {{"point_far", 0.5}, {"offer", 0.3}, {"point_front", 0.2}}}},
        {"behind past ago yesterday", {spatial, {{"over_shoulder", 1.0}}}},
        {"tomorrow future later soon", {concrete, {{"future", 1.0}}}},
        {"before after then next", {abstract, {{"progress", 0.6}, {"future", 0.4}}}},
        {"ahead straight forward front", {spatial, {{"progress", 0.6}, {"point_front", 0.4}}}},
        {"between middle inside centre into", {spatial, {{"together", 0.7}, {"small", 0.3}}}},
        {"around round circle circles ring turn turns turned wheel",
         {spatial, {{"turning", 0.7}, {"round", 0.3}}}},
        {"across through along way road path street walk go goes going went walked run travel",
         {concrete, {{"progress", 0.4}, {"continue", 0.3}, {"travel", 0.3}}}},
        {"far away outside", {spatial, {{"point_far", 0.7}, {"future", 0.3}}}},
        {"big huge enormous gigantic massive vast wide large broad long immense great",
         {concrete, {{"apart", 0.4}, {"embrace", 0.3}, {"big", 0.3}}}},
        {"tall high higher tower mountain", {concrete, {{"rising", 0.7}, {"tall", 0.3}}}},
        {"small tiny little narrow short thin smaller", {concrete, {{"together", 0.5}, {"small", 0.5}}}},
        {"flat table wall square field sea", {concrete, {{"surface", 0.6}, {"present", 0.4}}}},
        {"box house room bowl building basket",
         {concrete, {{"present", 0.5}, {"frame", 0.3}, {"container", 0.2}}}},
        {"all everything everybody everyone every whole world everywhere",
         {concrete, {{"embrace", 0.8}, {"open_arms", 0.2}}}},
        {"both together same union equal", {concrete, {{"together", 1.0}}}},
        {"apart different difference gap half divides parts", {concrete, {{"apart", 1.0}}}},
        {"or either maybe balance compare other others than depends", {concrete, {{"weighing", 1.0}}}},
        {"one two three four five six seven eight nine ten",
         {abstract, {{"counting", 0.5}, {"beat_precision", 0.5}}}},
        {"first second third finally last number",
         {concrete, {{"listing", 0.5}, {"counting", 0.3}, {"progress", 0.2}}}},
        {"more rises rose grew grows increased increases climbed bigger",
         {concrete, {{"progress", 0.5}, {"rising", 0.5}}}},
        {"less fell drops dropped sank decreased falls shrank",
         {concrete, {{"falling", 0.6}, {"small", 0.4}}}},
        {"no not never nothing nobody none cannot can't don't without neither",
         {concrete, {{"cut_off", 0.5}, {"shake_head", 0.3}, {"refuse", 0.2}}}},
        {"stop wait enough", {concrete, {{"stop_both", 0.7}, {"refuse", 0.3}}}},
        {"why what how who where when which", {abstract, {{"offer", 0.6}, {"shrug", 0.4}}}},
        {"idea plan reason question answer problem story example theory method opinion rule",
         {abstract, {{"offer", 0.5}, {"present", 0.5}}}},
        {"give gave take took bring put offer show", {abstract, {{"offer", 0.7}, {"present", 0.3}}}},
        {"open opens opened begin begins start", {concrete, {{"apart", 0.6}, {"present", 0.4}}}},
        {"close closed end over finished", {abstract, {{"together", 0.6}, {"cut_off", 0.4}}}},
        {"you your", {pronoun, {{"offer", 0.7}, {"point_front", 0.3}}}},
        {"i me my myself", {pronoun, {{"hand_on_heart", 0.6}, {"point_self", 0.4}}}},
        {"we us our", {pronoun, {{"embrace", 1.0}}}},
        {"love heart happy proud grateful", {concrete, {{"hand_on_heart", 1.0}}}},
        {"hello hi welcome goodbye", {spatial, {{"wave", 0.6}, {"open_arms", 0.4}}}},
        {"thank thanks sorry please", {abstract, {{"hand_on_heart", 0.6}, {"bow", 0.4}}}},
        {"write letter book page read map", {abstract, {{"reading", 0.5}, {"present", 0.5}}}},
        {"throw threw push pull", {concrete, {{"throwing", 1.0}}}},
        {"slowly quiet calm gently", {abstract, {{"calm", 1.0}}}},
        {"come follow", {abstract, {{"beckon", 1.0}}}},
    };
    return all;
}

}  // namespace

const WordGestures* gesturesOf(std::string_view word) {
    static const std::map<std::string, const WordGestures*, std::less<>> places = [] {
        std::map<std::string, const WordGestures*, std::less<>> out;
        for (const auto& [words, gestures] : entries())
            for (std::size_t at = 0; at < words.size();) {
                const std::size_t end = std::min(words.find(' ', at), words.size());
                out.emplace(words.substr(at, end - at), &gestures);
                at = end + 1;
            }
        return out;
    }();
    const auto found = places.find(word);
    return found == places.end() ? nullptr : found->second;
}

}  // namespace deixis::motion
