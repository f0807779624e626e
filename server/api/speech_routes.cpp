// Speech: spoken or recorded, and its sound.
#include <cmath>
#include <utility>

#include "motion_json.hpp"
#include "speech/prosody/pitch.hpp"
#include "speech/voice/written_words.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double tenths = 10.0;
constexpr double millionths_of_second = 1e6;
constexpr std::size_t largest_upload = std::size_t{128} << 20U;

double seconds(double value) {
    return rounded(value, millionths_of_second);
}

Shape timeShape(const char* about) {
    return numberShape(about, 0.0);
}

Answer speechAnswer(const StudioWork::Speech& speech) {
    if (!speech) return tl::unexpected(speech.error());
    json out = speechJson(**speech);
    out["pitch"] = json::array();
    for (const double hz : (*speech)->spoken.pitch) out["pitch"].push_back(rounded(hz, tenths));
    out["pitch_fps"] = speech::prosody_frames_per_s;
    return jsonReply(out);
}

Route speakRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "POST";
    route.path = "/v1/speech";
    route.name = "speak";
    route.about =
        "A text spoken by a voice of its language; or a recording (WAV) with its English text, which is then "
        "found "
        "in it.";
    route.body = objectShape("", {textField(true), voiceField(*work)});
    route.form = {{"text", textField(true).shape},
                  {"sound", textShape("A WAV file in which the text is said, up to half an hour"), true, true,
                   "audio/wav"}};
    route.max_form_bytes = largest_upload;
    auto fields = speechFields();
    fields.push_back(
        mustField("pitch", listShape("Hz; 0: no pitch", numberShape("", 0.0, speech::highest_pitch_hz))));
    fields.push_back(
        mustField("pitch_fps", integerShape("Values of pitch a second; the first is at 0", 1, 1000)));
    route.outcomes = {{200, "The speech", "application/json", objectShape("", std::move(fields))}};
    route.run = [work](const Call& call) -> Answer {
        if (call.form) return speechAnswer(work->record(call.form->at("sound"), call.form->at("text")));
        return speechAnswer(work->speak(call.body["text"], call.body["voice"]));
    };
    return route;
}

Route soundRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "GET";
    route.path = "/v1/speech/{id}.wav";
    route.name = "sound";
    route.about = "The sound of a speech, while the server keeps it.";
    route.path_parts = {{"id", "speech_id of a speech or of generated gestures"}};
    route.in_parts = true;
    route.outcomes = {{200, "One channel of 16 bits", "audio/wav"}};
    route.run = [work](const Call& call) -> Answer {
        const auto speech = work->find(call.path.at("id"), std::nullopt);
        if (!speech) return tl::unexpected(speech.error());
        Reply reply;
        reply.content_type = "audio/wav";
        reply.bytes = std::shared_ptr<const std::string>(*speech, &(*speech)->wav);
        return reply;
    };
    return route;
}

}  // namespace

ShapeField textField(bool required) {
    ShapeField field =
        mustField("text", textShape("What is said, in the voice's language: in English at most 4000 words", 1,
                                    speech::max_text_bytes));
    field.required = required;
    return field;
}

ShapeField voiceField(const StudioWork& work) {
    const auto names = work.parts().voices.names();
    return mayField("voice", choiceShape("Who speaks", names), names.front());
}

std::vector<ShapeField> speechFields() {
    return {
        mustField("speech_id", textShape("Of its content", 1, 64)),
        mustField("words",
                  listShape("In order", objectShape("", {mustField("word", textShape("As it is written")),
                                                         mustField("start_s", timeShape("")),
                                                         mustField("end_s", timeShape(""))}))),
        mustField(
            "accents",
            listShape("Syllables that stand out, in order",
                      objectShape("", {mustField("start_s", timeShape("")), mustField("end_s", timeShape("")),
                                       mustField("strength", numberShape("", 0.0, 1.0)),
                                       mustField("word", integerShape("Index of its word", 0, 1e6))}))),
        mustField("duration_s", timeShape("Of the sound")),
        mustField("language", textShape("BCP 47", 1)),
        mustField("words_understood",
                  booleanShape("Whether gestures go by the words; else by the sound alone: the "
                               "language is not English")),
        mustField("sound", textShape("Where the sound is: /v1/speech/ID.wav"))};
}

json speechJson(const KeptSpeech& speech) {
    const Utterance& utterance = speech.spoken.utterance;
    json words = json::array();
    for (const SpokenWord& word : utterance.words)
        words.push_back(
            {{"word", word.text}, {"start_s", seconds(word.start_s)}, {"end_s", seconds(word.end_s)}});
    json accents = json::array();
    for (const Accent& accent : utterance.accents)
        accents.push_back({{"start_s", seconds(accent.start_s)},
                           {"end_s", seconds(accent.end_s)},
                           {"strength", rounded(accent.strength, millionths_of_second)},
                           {"word", accent.word}});
    return {{"speech_id", speech.id},
            {"words", std::move(words)},
            {"accents", std::move(accents)},
            {"duration_s", rounded(utterance.duration_s, 1e9)},
            {"language", speech.language},
            {"words_understood", speech::isEnglish(speech.language)},
            {"sound", "/v1/speech/" + speech.id + ".wav"}};
}

std::vector<Route> speechRoutes(const std::shared_ptr<StudioWork>& work) {
    return {speakRoute(work), soundRoute(work)};
}

}  // namespace deixis::server
