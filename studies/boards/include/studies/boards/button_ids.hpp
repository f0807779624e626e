// Ids of everything that can be pressed on panels, shared by the code that builds a panel and the code
// that reads a press.
#pragma once

namespace deixis::studies {

namespace button_id {
constexpr int go_on = 1;  ///< leaves a page
constexpr int resume = 2;
constexpr int end_session = 3;
constexpr int replay = 4;
constexpr int end_for_good = 5;  ///< asked after end_session and decline
constexpr int back = 6;          ///< from that question
constexpr int agree = 7;
constexpr int decline = 8;
constexpr int first_rating = 101;   ///< the lowest step of the scale; the others follow
constexpr int first_play = 201;     ///< plays stimulus 0; the others follow
constexpr int first_slider = 301;   ///< of stimulus 0; the others follow
constexpr int first_option = 1000;  ///< question i of a page: 1000 + 100 i + place of the option
constexpr int first_field = 5000;   ///< question i of a page: its slider or text field
}  // namespace button_id

}  // namespace deixis::studies
