#include "studies/language.hpp"

namespace deixis::studies {

const std::vector<std::pair<std::string_view, std::string_view>>& languageKeys() {
    static const std::vector<std::pair<std::string_view, std::string_view>> keys{
        // Buttons.
        {"continue", "Continue"},
        {"finish", "Finish"},
        {"resume", "Resume"},
        {"end_session", "End session"},
        {"end_yes", "Yes, end it"},
        {"go_back", "Go back"},
        {"agree", "I agree"},
        {"decline", "I do not agree"},
        {"confirm", "Confirm"},
        {"yes", "Yes"},
        {"no", "No"},
        {"show_again", "Show again"},
        {"play", "Play"},
        {"playing", "Playing"},
        {"play_again", "Play again"},
        {"erase", "Erase"},

        // Pages. A title stands above a text of the study's own.
        {"instructions_title", "Instructions"},
        {"consent_title", "Consent"},
        {"practice_again_title", "Practice again"},
        {"practice_again_text", "Please go through the practice once more. It does not count."},
        {"break_title", "Time for a break"},
        {"break_text", "Rest as long as you like."},
        {"break_seconds", "You can go on in {seconds} seconds."},
        {"break_second", "You can go on in 1 second."},
        {"page_seconds", "Please read this. You can go on in {seconds} seconds."},
        {"page_second", "Please read this. You can go on in 1 second."},
        {"welcome_back_title", "Welcome back"},
        {"welcome_back_text", "You go on where you stopped. Your earlier answers are kept."},
        {"thank_you_title", "Thank you"},
        {"thank_you_text", "You have finished. All your answers are kept."},
        {"sitting_over_text",
         "This session is over, and your answers are kept. The study goes on in another session."},
        {"declined_title", "Thank you for your time"},
        {"declined_text", "You have not agreed to take part, so the session ends here."},
        {"excluded_title", "The session ends here"},
        {"excluded_text", "The study cannot go on with these answers. Thank you for your time."},
        {"attention_title", "Please pay attention"},
        {"attention_text",
         "One of your answers was not what had been asked for. Please watch each movement to its end and "
         "answer with care."},

        // Pauses.
        {"paused_title", "Paused"},
        {"paused_text", "Go on when you are ready."},
        {"paused_focus_text", "Something else has come to the front. Go on when you are ready."},
        {"paused_operator_text",
         "The experimenter has paused the session. Please wait until you are asked to go on."},
        {"paused_headset_title", "Welcome back"},
        {"paused_headset_text",
         "All has waited for you. Go on when the headset sits well and you are ready."},
        {"paused_tracking_title", "One moment"},
        {"paused_tracking_text",
         "The headset has lost sight of the room. Stay where you are and look around slowly; go on when "
         "the room stands still again."},
        {"paused_end_hint",
         "If you end the session here, the answers given so far are kept and the rest can be done later."},
        {"end_title", "End the session?"},
        {"end_text",
         "The answers given so far are kept. The rest can be done later: the session then goes on where it "
         "stopped."},

        // One calm sentence beside all else.
        {"notice_saving", "One moment, please: your answer is being saved."},
        {"notice_pointer", "Pick up a controller and press any button."},
        {"notice_place", "Please step back onto your place."},
        {"notice_time_up", "Time is up. The next one follows."},
        {"notice_time_left", "{seconds} seconds left."},
        {"notice_second_left", "1 second left."},

        // Answers.
        {"attention_number", "Please rate this movement:"},
        {"left", "Left"},
        {"right", "Right"},
        {"prefer_left_clearly", "Clearly left"},
        {"prefer_left_slightly", "Slightly left"},
        {"prefer_neither", "No difference"},
        {"prefer_right_slightly", "Slightly right"},
        {"prefer_right_clearly", "Clearly right"},
        {"play_all", "Play each movement to its end."},
        {"play_both", "Play both movements to their end."},
        {"rate_all", "Rate every movement, then confirm."},
        {"feedback_correct", "Correct: this was the target."},
        {"feedback_wrong", "Not quite: the green ball was the target."},
        {"page_of", "Page {page} of {pages}"},
        {"answer_all", "Please answer all questions."},
        {"answer_one", "Please answer the question."},
        {"answer_number", "Please enter a number from {low} to {high}."},
        {"number_hint", "{low} to {high}"},
        {"text_hint", "Type your answer"},
        {"choices_hint", "You can choose more than one."},

        // The stations' own.
        {"station_desktop_controls",
         "Mouse: look and aim.  Left button: select.  Enter: continue.  1-9: rate.  Esc: pause."},
        {"station_headset_controls",
         "Trigger: select.  Menu button: pause.  Thumbstick held for a second: recentre."},
        {"station_headset_hint", "Aim the ray at a button and pull the trigger."},
        {"station_tracking_lost", "The headset has lost sight of the room. Look around slowly."},
    };
    return keys;
}

}  // namespace deixis::studies
