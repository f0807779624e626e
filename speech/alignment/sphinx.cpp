#include "sphinx.hpp"

#include <pocketsphinx.h>

#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

#if __has_include(<sphinxbase/err.h>)
#include <sphinxbase/err.h>
#include <sphinxbase/jsgf.h>
#define DEIXIS_POCKETSPHINX_BEFORE_5
#endif

namespace deixis::speech {

namespace {

constexpr const char* search_name = "deixis";

void logNothing(void*, err_lvl_t, const char*, ...) {}

/// Wide beams: the way through a known text is narrow, and must not be lost.
constexpr std::array<std::pair<const char*, const char*>, 3> beams{
    {{"beam", "1e-80"}, {"pbeam", "1e-80"}, {"wbeam", "1e-60"}}};

#ifdef DEIXIS_POCKETSPHINX_BEFORE_5

ps_decoder_t* decoderOf(const std::string& acoustic, const std::string& dictionary) {
    cmd_ln_t* const config =
        cmd_ln_init(nullptr, ps_args(), TRUE, "-hmm", acoustic.c_str(), "-dict", dictionary.c_str(), nullptr);
    if (config == nullptr) return nullptr;
    for (const auto& [name, value] : beams)
        cmd_ln_set_float_r(config, (std::string("-") + name).c_str(), std::strtod(value, nullptr));
    cmd_ln_set_str_r(config, "-cmn", "batch");
    // Frames that it left out would move all that follow.
    cmd_ln_set_boolean_r(config, "-remove_silence", FALSE);
    cmd_ln_set_boolean_r(config, "-bestpath", FALSE);
    ps_decoder_t* const decoder = ps_init(config);
    cmd_ln_free_r(config);
    return decoder;
}

bool setGrammar(ps_decoder_t* decoder, fsg_model_t* grammar) {
    return ps_set_fsg(decoder, search_name, grammar) == 0 && ps_set_search(decoder, search_name) == 0;
}

#else

ps_decoder_t* decoderOf(const std::string& acoustic, const std::string& dictionary) {
    ps_config_t* const config = ps_config_init(nullptr);
    if (config == nullptr) return nullptr;
    ps_config_set_str(config, "hmm", acoustic.c_str());
    ps_config_set_str(config, "dict", dictionary.c_str());
    for (const auto& [name, value] : beams) ps_config_set_float(config, name, std::strtod(value, nullptr));
    ps_config_set_str(config, "cmn", "batch");
    ps_config_set_bool(config, "bestpath", 0);
    ps_decoder_t* const decoder = ps_init(config);
    ps_config_free(config);
    return decoder;
}

bool setGrammar(ps_decoder_t* decoder, fsg_model_t* grammar) {
    return ps_add_fsg(decoder, search_name, grammar) == 0 && ps_activate_search(decoder, search_name) == 0;
}

#endif

/// Not ps_set_jsgf_string(), which keeps what it has parsed for ever.
bool setGrammarText(ps_decoder_t* decoder, const std::string& text) {
    constexpr float language_weight = 6.5F;  // PocketSphinx's own
    jsgf_t* const parsed = jsgf_parse_string(text.c_str(), nullptr);
    if (parsed == nullptr) return false;
    fsg_model_t* grammar = nullptr;
    if (jsgf_rule_t* const rule = jsgf_get_public_rule(parsed))
        grammar = jsgf_build_fsg(parsed, rule, ps_get_logmath(decoder), language_weight);
    jsgf_grammar_free(parsed);
    if (grammar == nullptr) return false;
    const bool set = setGrammar(decoder, grammar);
    fsg_model_free(grammar);
    return set;
}

/// "<sil>", "[NOISE]", "++UM++", and grammars' steps without a word, "(NULL)".
bool isFiller(const std::string& name) {
    return name.empty() || std::string_view("<[+(").find(name.front()) != std::string_view::npos;
}

}  // namespace

void Sphinx::Free::operator()(ps_decoder_s* decoder) const {
    ps_free(decoder);
}

Result<Sphinx> Sphinx::load(const std::filesystem::path& model) {
    const std::filesystem::path acoustic = model / "en-us", dictionary = model / "cmudict-en-us.dict";
    std::error_code code;
    for (const auto& needed : {acoustic / "mdef", dictionary})
        if (!std::filesystem::is_regular_file(needed, code))
            return fail(needed.string(), "is not there, expected PocketSphinx's model of US English",
                        "Install Debian's package pocketsphinx-en-us");
    err_set_logfp(nullptr);
    err_set_callback(logNothing, nullptr);
    ps_decoder_t* const decoder = decoderOf(acoustic.string(), dictionary.string());
    if (decoder == nullptr)
        return fail(model.string(), "PocketSphinx cannot read the model",
                    "Install Debian's package pocketsphinx-en-us again");
    return Sphinx(decoder);
}

std::vector<std::string> Sphinx::pronunciationsOf(const std::string& word) const {
    std::vector<std::string> out;
    for (int i = 1;; ++i) {
        const std::string name = i == 1 ? word : word + "(" + std::to_string(i) + ")";
        char* const phones = ps_lookup_word(decoder_.get(), name.c_str());
        if (phones == nullptr) return out;
        out.emplace_back(phones);
        std::free(phones);
    }
}

bool Sphinx::addWord(const std::string& name, const std::vector<std::string>& pronunciations) {
    if (!pronunciationsOf(name).empty()) return true;
    for (std::size_t i = 0; i < pronunciations.size(); ++i) {
        const std::string variant = i == 0 ? name : name + "(" + std::to_string(i + 1) + ")";
        if (ps_add_word(decoder_.get(), variant.c_str(), pronunciations[i].c_str(), 0) < 0) return false;
    }
    return !pronunciations.empty();
}

std::vector<FoundWord> Sphinx::find(const std::string& grammar, const std::vector<std::int16_t>& samples) {
    std::vector<FoundWord> out;
    ps_decoder_t* const decoder = decoder_.get();
    if (!setGrammarText(decoder, "#JSGF V1.0;\ngrammar text;\npublic <all> = " + grammar + ";\n")) return out;
    if (ps_start_utt(decoder) < 0) return out;
    ps_process_raw(decoder, samples.data(), samples.size(), 0, 1);
    if (ps_end_utt(decoder) < 0) return out;
    int32 whole_score = 0;
    if (ps_get_hyp(decoder, &whole_score) == nullptr) return out;
    for (ps_seg_t* part = ps_seg_iter(decoder); part != nullptr; part = ps_seg_next(part)) {
        FoundWord word;
        word.name = ps_seg_word(part);
        if (isFiller(word.name)) continue;
        word.name.resize(std::min(word.name.size(), word.name.find('(')));
        ps_seg_frames(part, &word.first, &word.last);
        int32 acoustic = 0, language = 0, backoff = 0;
        ps_seg_prob(part, &acoustic, &language, &backoff);
        word.score = acoustic;
        out.push_back(std::move(word));
    }
    return out;
}

}  // namespace deixis::speech
