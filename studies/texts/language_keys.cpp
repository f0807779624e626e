#include "studies/texts/language.hpp"

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
        {"practice_again_title", "One more practice round"},
        {"practice_again_text", "Please do the practice once more. These answers do not count yet."},
        {"break_title", "Time for a break"},
        {"break_text", "Take as long as you like."},
        {"break_seconds", "You can continue in {seconds} seconds."},
        {"break_second", "You can continue in 1 second."},
        {"page_seconds", "Please read this page. You can continue in {seconds} seconds."},
        {"page_second", "Please read this page. You can continue in 1 second."},
        {"welcome_back_title", "Welcome back"},
        {"welcome_back_text", "You will continue where you left off. Your earlier answers have been saved."},
        {"thank_you_title", "Thank you"},
        {"thank_you_text", "You have finished. All your answers have been saved."},
        {"session_over_text",
         "That was all for this session. Your answers have been saved. The study continues in another "
         "session."},
        {"declined_title", "Thank you for your time"},
        {"declined_text", "You chose not to take part, so the session ends here."},
        {"excluded_title", "The session ends here"},
        {"excluded_text",
         "Your answers did not meet what this study requires, so it cannot continue. Thank you for your "
         "time."},
        {"stopped_title", "The session stops here"},
        {"stopped_text",
         "There is a technical problem. You did nothing wrong. Please tell the experimenter."},
        {"attention_title", "Please pay attention"},
        {"attention_text",
         "One of your answers was not what we had asked for. Please watch every movement to the end and "
         "answer carefully."},

        // Pauses.
        {"paused_title", "Paused"},
        {"paused_text", "Continue when you are ready."},
        {"paused_focus_text", "Another window or menu was opened. Continue when you are ready."},
        {"paused_operator_text",
         "The experimenter has paused the session. Please wait until you are asked to continue."},
        {"paused_headset_title", "Welcome back"},
        {"paused_headset_text",
         "The session was paused while the headset was off. Make sure it sits comfortably, then continue "
         "when you are ready."},
        {"paused_tracking_title", "One moment"},
        {"paused_tracking_text",
         "The headset has lost track of where it is. Stay where you are and look around slowly. Continue "
         "once the room has stopped moving."},
        {"paused_end_hint",
         "If you end the session here, your answers so far are kept and you can do the rest later."},
        {"end_title", "End the session?"},
        {"end_text",
         "Your answers so far are kept. You can do the rest later and will continue where you left off."},

        // One calm sentence beside all else.
        {"notice_saving", "One moment, please: your answer is being saved."},
        {"notice_pointer", "Please pick up a controller and press any button."},
        {"notice_place", "Please step back to your place."},
        {"notice_time_up", "Time is up. The next one is coming."},
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
        {"play_all", "Please play every movement to the end."},
        {"play_both", "Please play both movements to the end."},
        {"rate_all", "Rate every movement, then press Confirm."},
        {"feedback_correct", "Correct, that was the ball."},
        {"feedback_wrong", "Not quite: it was the green ball."},
        {"page_of", "Page {page} of {pages}"},
        {"answer_all", "Please answer all questions."},
        {"answer_one", "Please answer the question."},
        {"answer_number", "Please enter a number from {low} to {high}."},
        {"number_hint", "{low} to {high}"},
        {"text_hint", "Type your answer"},
        {"choices_hint", "You can choose more than one."},

        // The stations' own.
        {"station_desktop_controls",
         "Mouse: point.  Left button: select.  Hold the right button: look around.  Enter: continue.  "
         "1-9: rate.  Esc: pause."},
        {"station_headset_controls",
         "Trigger: select.  Menu button: pause.  Hold the thumbstick for a second: recentre."},
        {"station_headset_hint", "Point the ray at a button and pull the trigger."},
        {"station_tracking_lost", "The headset has lost track of where it is. Please look around slowly."},
    };
    return keys;
}

}  // namespace deixis::studies
