#include "session_shapes.hpp"

#include <string>
#include <utility>

namespace deixis::server {

namespace {

constexpr double most = 9007199254740991.0;  // that JavaScript counts to

Shape orNull(Shape shape) {
    shape.nullable = true;
    return shape;
}

ShapeField boxField(const char* name, const char* about) {
    return mustField(name, listShape(about, numberShape(""), 4, 4));
}

ShapeField idField() {
    return mustField("id", integerShape("", 0, 1e9));
}

ShapeField listField(const char* name, const char* about, std::vector<ShapeField> fields) {
    return mustField(name, listShape(about, objectShape("", std::move(fields))));
}

Shape panelShape() {
    const Shape metres = numberShape("Metres", 0.0);
    return objectShape(
        "The board that is read and pressed; boxes are [x, y, width, height] in metres from its lower left "
        "corner, y up",
        {mustField("width_m", metres), mustField("height_m", metres),
         mustField("progress", orNull(numberShape("Of the visit", 0.0, 1.0))),
         listField(
             "texts", "",
             {boxField("box", ""), mustField("text", textShape("Its lines")),
              mustField("size_m", numberShape("A line's height", 0.0)), mustField("bold", booleanShape("")),
              mustField("centred", booleanShape("")), mustField("faint", booleanShape("")),
              mustField("level", booleanShape("In the middle of the box's height"))}),
         listField(
             "buttons", "",
             {boxField("box", ""), mustField("label", textShape("")), mustField("caption", textShape("")),
              idField(), mustField("enabled", booleanShape("")), mustField("chosen", booleanShape("")),
              mustField("role", choiceShape("", {"go_on", "leave", "play", "option", "other"}))}),
         listField(
             "sliders", "",
             {boxField("box", ""), boxField("track", "From low to high"), idField(),
              mustField("low", integerShape("", -1e9, 1e9)), mustField("high", integerShape("", -1e9, 1e9)),
              mustField("value", orNull(integerShape("null: untouched", -1e9, 1e9))),
              mustField("labels", listShape("Spread evenly under the track", textShape(""))),
              mustField("label_size_m", numberShape("", 0.0)), mustField("enabled", booleanShape(""))}),
         listField("fields", "For typing",
                   {boxField("box", ""), idField(), mustField("text", textShape("")),
                    mustField("hint", textShape("Where it is empty")), mustField("active", booleanShape("")),
                    mustField("enabled", booleanShape(""))})});
}

Shape projectShape(const char* about) {
    return openObjectShape(about, {mustField("version", integerShape("", 0, 1e9))});
}

Shape authoringShape() {
    return objectShape(
        "The trial in which gestures are made; also while it is paused",
        {mustField("trial", integerShape("1.. of the stage", 1, 1e6)),
         mustField("of", integerShape("", 1, 1e6)), mustField("practice", booleanShape("It does not count")),
         mustField("system", textShape("By whose means gestures are made", 1)),
         mustField("keyframes_only", booleanShape("With neither model nor styles")),
         mustField("question", textShape("What is asked")),
         mustField("project", openObjectShape("What to start from, or the work as it was told last", {})),
         mustField("limit_s", numberShape("", 0.0)), mustField("left_s", numberShape("Pauses aside", 0.0)),
         mustField("may_end_early", booleanShape(""))});
}

}  // namespace

Shape sessionShape() {
    return objectShape(
        "", {mustField("revision", integerShape("Changes with all but left_s and project", 0, most)),
             mustField("state", textShape("Such as instructions, questionnaire, authoring, paused, over")),
             mustField("stage", textShape("Its name; empty: none")),
             mustField("notice", textShape("One sentence beside all else; empty: none")),
             mustField("over", booleanShape("Nothing follows")), mustField("panel", orNull(panelShape())),
             mustField("authoring", orNull(authoringShape()))});
}

Shape revisionAnswer() {
    return objectShape("", {mustField("revision", integerShape("Of what is shown now", 0, most))});
}

ShapeField revisionField() {
    return mustField("revision", integerShape("Of the board that it was done on", 0, most));
}

std::vector<ShapeField> workFields() {
    constexpr std::size_t most_edits = 2000;
    Shape edit = openObjectShape("", {mustField("at_s", numberShape("Of the trial's time", 0.0, 1e6)),
                                      mustField("what", textShape("In words", 0, 500))});
    return {mustField("trial", integerShape("Which it is of", 1, 1e6)),
            mustField("project", projectShape("As it is now, of at most 16 MiB")),
            mayField("edits", listShape("Since the work before", std::move(edit), 0, most_edits),
                     nlohmann::json::array()),
            mayField("generated",
                     integerShape("How often gestures were generated since the work before", 0, 1e6), 0)};
}

}  // namespace deixis::server
