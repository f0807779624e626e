#include <array>

#include "board_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

BoardSlider ratingSlider() {
    BoardSlider slider;
    slider.box = {0.05, 0.15, 0.9, 0.2};
    slider.track = {0.1, 0.28, 0.8, 0.016};
    slider.labels = {"low", "middle", "high"};
    return slider;
}

// Around the track at a share of its length, above it: only a thumb reaches there.
BoardRect overTrack(const BoardSlider& slider, double share) {
    return {slider.track.x + share * slider.track.width - 0.008, slider.track.y + slider.track.height + 0.003,
            0.016, 0.006};
}

BoardField textField() {
    BoardField field;
    field.box = {0.1, 0.2, 0.8, 0.1};
    field.hint = "Type your answer";
    return field;
}

Scene withField(const BoardField& field) {
    Scene scene = bareBoardScene();
    scene.boards[0].fields = {field};
    return scene;
}

Scene withButton(ButtonLook look, const char* label = "Go") {
    Scene scene = bareBoardScene();
    BoardButton button;
    button.box = {0.3, 0.15, 0.4, 0.2};
    button.label = label;
    button.look = look;
    scene.boards[0].buttons = {button};
    return scene;
}

// Within the button beside its label, and its upper right corner.
constexpr BoardRect button_ground{0.33, 0.17, 0.06, 0.03};
constexpr BoardRect button_corner{0.655, 0.305, 0.036, 0.036};

}  // namespace

TEST_SUITE("renderer/slider") {
    TEST_CASE("A thumb stands where the value is, and nowhere on an untouched track") {
        Gl gl;
        Scene scene = bareBoardScene();
        for (const double value : {0.0, 0.25, 1.0}) {
            CAPTURE(value);
            BoardSlider slider = ratingSlider();
            slider.value = value;
            scene.boards[0].sliders = {slider};
            const Image image = boardPicture(gl, scene);
            for (const double share : {0.0, 0.25, 0.5, 1.0}) {
                CAPTURE(share);
                const Region over = region(image, scene, overTrack(slider, share));
                if (share == value)
                    CHECK(over.mean > 150.0);
                else
                    CHECK(over.brightest < 90);
            }
        }
        scene.boards[0].sliders = {ratingSlider()};
        const Image untouched = boardPicture(gl, scene);
        for (const double share : {0.0, 0.25, 0.5, 1.0})
            CHECK(region(untouched, scene, overTrack(ratingSlider(), share)).brightest < 90);
    }

    TEST_CASE(
        "An untouched track is hollow, one with a value filled, one under the ray lit, a closed one dim") {
        Gl gl;
        Scene scene = bareBoardScene();
        const auto trackOf = [&](const BoardSlider& slider) {
            scene.boards[0].sliders = {slider};
            return region(boardPicture(gl, scene), scene, {0.6, 0.284, 0.1, 0.006});
        };
        BoardSlider slider = ratingSlider();
        const Region hollow = trackOf(slider);
        slider.value = 0.2;
        const Region filled = trackOf(slider);
        slider.hovered = true;
        const Region lit = trackOf(slider);
        slider.enabled = false;  // a closed one is not lit either
        const Region closed = trackOf(slider);
        CHECK(filled.mean > hollow.mean + 60.0);
        CHECK(lit.yellow > filled.yellow + 60.0);
        CHECK(lit.mean > filled.mean + 40.0);
        CHECK(closed.mean < filled.mean - 40.0);
        CHECK(closed.yellow < 20.0);
    }

    TEST_CASE("Labels stand under their ticks: the outer ones at the track's ends, one more in its middle") {
        Gl gl;
        Scene scene = bareBoardScene();
        scene.boards[0].sliders = {ratingSlider()};
        const Image image = boardPicture(gl, scene);
        const auto under = [&](double x, double half) {
            return region(image, scene, {x - half, 0.16, 2.0 * half, 0.085}).brightest;
        };
        for (const double tick : {0.1, 0.5, 0.9}) CHECK(under(tick, 0.04) > 170);
        for (const double between : {0.3, 0.7}) CHECK(under(between, 0.08) < 70);
        // The ticks themselves.
        const auto tick = [&](double x) {
            return region(image, scene, {x - 0.003, 0.266, 0.006, 0.008}).brightest;
        };
        for (const double at : {0.1, 0.5, 0.9}) CHECK(tick(at) > tick(at + (at < 0.9 ? 0.1 : -0.1)) + 50);
    }
}

TEST_SUITE("renderer/field") {
    TEST_CASE("An empty field shows its hint, fainter than what is typed then") {
        Gl gl;
        BoardField field = textField();
        Scene scene = withField(field);
        const Region hint = region(boardPicture(gl, scene), scene, field.box);
        field.hint.clear();
        scene = withField(field);
        const BoardRect inside{0.12, 0.21, 0.7, 0.08};
        CHECK(region(boardPicture(gl, scene), scene, inside).brightest < 60);
        field.text = "Type your answer";
        scene = withField(field);
        const Region typed = region(boardPicture(gl, scene), scene, field.box);
        CHECK(hint.brightest > 130);
        CHECK(typed.brightest > hint.brightest + 30);
    }

    TEST_CASE("The caret of the active field stands behind the text and moves on with it") {
        Gl gl;
        BoardField field = textField();
        field.hint.clear();
        const auto caretAt = [&](const char* text) {
            field.text = text;
            field.active = false;
            Scene scene = withField(field);
            const Image without = boardPicture(gl, scene);
            field.active = true;
            scene = withField(field);
            const Image with = boardPicture(gl, scene);
            // The rightmost bright column that only the active field has, within the frame's line.
            double found = -1.0;
            for (double x = 0.115; x < 0.885; x += 0.002) {
                const BoardRect column{x, 0.225, 0.002, 0.05};
                if (region(with, scene, column).brightest > region(without, scene, column).brightest + 60)
                    found = x;
            }
            return found;
        };
        const double empty = caretAt("");
        const double one = caretAt("word");
        const double two = caretAt("word word");
        CHECK(empty > 0.11);
        CHECK(empty < 0.14);
        CHECK(one > empty + 0.05);
        CHECK(two - one > 0.9 * (one - empty));
    }

    TEST_CASE("The hint leaves room for the caret before it") {
        Gl gl;
        BoardField field = textField();
        field.hint = "HHHH";
        field.active = true;
        Scene scene = withField(field);
        scene.camera = lookingFrom({-0.38, 1.2, 1.9}, {-0.38, 1.2, 1.6});
        const Image image = boardPicture(gl, scene);
        CHECK(region(image, scene, {0.1215, 0.24, 0.0015, 0.02}).brightest > 200);  // the caret
        CHECK(region(image, scene, {0.1255, 0.235, 0.0025, 0.03}).brightest < 90);
        CHECK(region(image, scene, {0.13, 0.235, 0.03, 0.03}).brightest > 130);
    }

    TEST_CASE("A text too long for the field shows its end and stays within") {
        Gl gl;
        BoardField field = textField();
        field.text = std::string(80, 'm') + " Ende";
        Scene scene = withField(field);
        const Image image = boardPicture(gl, scene);
        field.text = std::string(80, 'm') + " Enge";
        Scene other = withField(field);
        const Image changed = boardPicture(gl, other);
        CHECK(image.rgb != changed.rgb);
        CHECK(region(image, scene, {0.92, 0.15, 0.06, 0.2}).brightest < 70);
        CHECK(region(image, scene, {0.02, 0.15, 0.06, 0.2}).brightest < 70);
    }

    TEST_CASE("A high field has several lines") {
        Gl gl;
        BoardField field = textField();
        field.box = {0.1, 0.1, 0.8, 0.3};
        field.text =
            "This is so long a text that one line of the field is by far not enough for all of it to stand "
            "in.";
        const Scene scene = withField(field);
        const Image image = boardPicture(gl, scene);
        CHECK(region(image, scene, {0.13, 0.345, 0.7, 0.03}).brightest > 150);
        CHECK(region(image, scene, {0.13, 0.30, 0.7, 0.03}).brightest > 150);
    }
}

TEST_SUITE("renderer/buttons") {
    TEST_CASE("What leads on is filled brightly, what leaves is an outline, all else lies between") {
        Gl gl;
        const auto groundOf = [&](ButtonLook look) {
            const Scene scene = withButton(look);
            return region(boardPicture(gl, scene), scene, button_ground).mean;
        };
        const double card = region(boardPicture(gl, bareBoardScene()), bareBoardScene(), button_ground).mean;
        CHECK(groundOf(ButtonLook::leave) == doctest::Approx(card).epsilon(0.02));
        CHECK(groundOf(ButtonLook::plain) > card + 20.0);
        CHECK(groundOf(ButtonLook::option) == doctest::Approx(groundOf(ButtonLook::plain)));
        CHECK(groundOf(ButtonLook::go_on) > groundOf(ButtonLook::plain) + 80.0);
        // The outline itself.
        const Scene leave = withButton(ButtonLook::leave);
        CHECK(region(boardPicture(gl, leave), leave, {0.297, 0.22, 0.008, 0.06}).brightest > card + 60.0);
    }

    TEST_CASE("A play button has a triangle before its label, which points to the right") {
        Gl gl;
        const Scene plain = withButton(ButtonLook::plain, "");
        const Scene play = withButton(ButtonLook::play, "");
        const Image image = boardPicture(gl, play);
        const auto columnLight = [&](double x) { return region(image, play, {x, 0.2, 0.004, 0.1}).mean; };
        // Without a label it is in the button's middle: higher at its left than at its right.
        CHECK(columnLight(0.490) > columnLight(0.506) + 5.0);
        CHECK(region(image, play, {0.48, 0.23, 0.04, 0.04}).brightest >
              region(boardPicture(gl, plain), plain, {0.48, 0.23, 0.04, 0.04}).brightest + 80);
        const Scene labelled = withButton(ButtonLook::play, "I");
        const Image with_label = boardPicture(gl, labelled);
        CHECK(region(with_label, labelled, {0.455, 0.24, 0.03, 0.02}).brightest > 150);
    }

    TEST_CASE("A chosen option has a tick in its corner beside its colour; hovering leaves the tick") {
        Gl gl;
        for (const bool hovered : {false, true}) {
            CAPTURE(hovered);
            Scene scene = withButton(ButtonLook::option);
            scene.boards[0].buttons[0].hovered = hovered;
            const Image open = boardPicture(gl, scene);
            scene.boards[0].buttons[0].chosen = true;
            const Image chosen = boardPicture(gl, scene);
            const Region before = region(open, scene, button_corner);
            const Region after = region(chosen, scene, button_corner);
            CHECK(before.brightest - before.darkest < 60);
            CHECK(after.brightest - after.darkest > 90);
            if (!hovered)
                CHECK(std::abs(region(chosen, scene, button_ground).mean -
                               region(open, scene, button_ground).mean) > 15.0);
        }
        // One that can no longer be changed still shows what was chosen.
        Scene scene = withButton(ButtonLook::option);
        scene.boards[0].buttons[0].chosen = true;
        scene.boards[0].buttons[0].enabled = false;
        const Region kept = region(boardPicture(gl, scene), scene, button_corner);
        CHECK(kept.brightest - kept.darkest > 90);
    }
}

TEST_SUITE("renderer/letters") {
    TEST_CASE(
        "Hangul, umlauts and a letter with a ring are each drawn as themselves, and nothing is missing") {
        Gl gl;
        Scene scene = bareBoardScene();
        std::vector<double> means;
        for (const bool bold : {false, true})
            for (const char* text : {"?", "가", "각", "힣", "ㄱ", "ö", "ß", "å"}) {
                CAPTURE(text);
                scene.boards[0].texts = {{{0.3, 0.15, 0.4, 0.2}, text, 0.16, bold, true, false}};
                const Region drawn = region(boardPicture(gl, scene), scene, {0.3, 0.15, 0.4, 0.2});
                CHECK(drawn.brightest > 190);
                means.push_back(drawn.mean);
            }
        std::sort(means.begin(), means.end());
        CHECK(std::adjacent_find(means.begin(), means.end()) == means.end());
        CHECK(gl.renderer->missingCharacters().empty());
    }

    TEST_CASE("A character that no font has is a question mark, and told once") {
        Gl gl;
        Scene scene = bareBoardScene();
        const auto picture = [&](const char* text) {
            scene.boards[0].texts = {{{0.3, 0.15, 0.4, 0.2}, text, 0.16, false, true, false}};
            return boardPicture(gl, scene);
        };
        const Image question = picture("?");
        const Image lacking = picture("\u0915");  // Devanagari
        CHECK(lacking.rgb == question.rgb);
        CHECK(gl.renderer->missingCharacters() == "\u0915");
        static_cast<void>(picture("\u0915 \u0916"));
        static_cast<void>(picture("plain"));
        CHECK(gl.renderer->missingCharacters() == "\u0915\u0916");
    }

    TEST_CASE("A word a little too long for its box is made smaller rather than cut") {
        Gl gl;
        Scene scene = bareBoardScene();
        scene.boards[0].texts = {{{0.05, 0.05, 0.26, 0.42}, "Excellent", 0.07}};
        const Image image = boardPicture(gl, scene);
        CHECK(region(image, scene, {0.05, 0.41, 0.26, 0.05}).brightest > 150);
        CHECK(region(image, scene, {0.05, 0.30, 0.26, 0.09}).brightest < 70);
    }
}

TEST_SUITE("renderer/boards") {
    TEST_CASE(
        "Several boards are each painted once and drawn in their places, the nearer before the farther") {
        Gl gl;
        Scene scene = bareBoardScene();
        const std::array<const char*, 3> words{"first", "second", "third"};
        scene.boards.clear();
        for (std::size_t i = 0; i < words.size(); ++i) {
            Board board;
            board.width_m = 0.3;
            board.height_m = 0.2;
            board.stage_from_board.position = Vec3(-0.6 + 0.45 * static_cast<double>(i), 1.1, 1.6);
            board.texts = {{{0.02, 0.05, 0.26, 0.1}, words[i], 0.09, true, true}};
            scene.boards.push_back(board);
        }
        Image image = boardPicture(gl, scene);
        for (std::size_t i = 0; i < words.size(); ++i)
            CHECK(region(image, scene, {0.02, 0.05, 0.26, 0.1}, i).brightest > 150);
        static_cast<void>(boardPicture(gl, scene));
        CHECK(gl.renderer->boardPaints() == 3);
        // Only what changed is painted: one board's content, as that of a slider that is dragged.
        for (int i = 0; i < 5; ++i) {
            scene.boards[1].texts[0].text += 'x';
            static_cast<void>(boardPicture(gl, scene));
        }
        CHECK(gl.renderer->boardPaints() == 8);
        // One more than are kept: still all are there.
        scene.boards.push_back(scene.boards[0]);
        scene.boards[3].texts[0].text = "fourth";
        scene.boards[3].stage_from_board.position += Vec3(0.02, 0.02, 0.2);
        image = boardPicture(gl, scene);
        CHECK(gl.renderer->boardPaints() == 9);
        CHECK(region(image, scene, {0.02, 0.05, 0.26, 0.1}, 3).brightest > 150);
        // The fourth covers the first.
        Scene alone = scene;
        alone.boards.erase(alone.boards.begin());
        CHECK(region(boardPicture(gl, alone), scene, {0.02, 0.05, 0.26, 0.1}, 3).mean ==
              doctest::Approx(region(image, scene, {0.02, 0.05, 0.26, 0.1}, 3).mean).epsilon(0.01));
    }
}
