// unit/screen_player.h: a scripted player that knows nothing about the game except what is on the screen
// (screen_reader.h). It reads the names of controls in brackets, learns from the lessons what they do, and
// uses that later. It reads as slowly as a person, but reacts at once to what it sees.
#pragma once
#include <map>
#include <set>

#include "unit/screen_reader.h"

namespace thaum::game::screen {

/// State of the player's hands until the next look at the screen: keys, buttons and mouse.
struct Hands {
    std::set<std::string>
        held{};      ///< controls that are down, by their names on the screen: "W", "Left mouse"
    fvec2 mouse{0};  ///< motion of the mouse to the right and down (counts)
    std::optional<fvec2> click{};  ///< place in a menu at which the left mouse button is clicked (px)
};

/// Controls that the lessons have named.
struct Learnt {
    std::vector<std::string> walk{};  ///< controls for walking: forward, left, back, right
    std::string fire{}, stir{}, drop{};
    bool mouse = false;                          ///< true: the mouse turns the view
    std::map<std::string, std::string> wands{};  ///< control of each wand, by the wand's name: "Bolt"
};

/// Time between two looks at the screen (ticks).
inline constexpr Tick look_period = 16;

/// Device with which the player chooses the rows of a menu.
enum class MenuHand : std::uint8_t { mouse, keys };

class Player {
public:
    explicit Player(MenuHand menu_hand = MenuHand::mouse) : menu_hand_(menu_hand) {}

    /// Looks at the screen, and decides what the hands do.
    Hands act(const Screen& seen);

    const Learnt& learnt() const { return learnt_; }
    /// Texts of the panel with the result, after a round.
    const std::string& result() const { return result_; }
    const std::string& name() const { return name_; }
    /// Whether the screen has shown that the Apprentice (the guided lessons) is completed.
    bool has_done_lessons() const { return done_lessons_; }
    /// The bot that the start screen has named for the duel: "Novice".
    const std::string& bot() const { return bot_; }

private:
    // What the player does in menus.
    void use_menu(const Screen& seen, Hands& hands);
    const Words* wanted_row(const Screen& seen);
    std::string key_towards(const Screen& seen, const Words& row);

    // What the player does in lessons.
    void read(const std::string& words);
    void follow_lesson(const Screen& seen, Hands& hands);
    void do_lesson(const Screen& seen, Hands& hands);
    void look_about(const Screen& seen, Hands& hands);
    void draw_circle(Hands& hands) const;
    void shoot(const Screen& seen, Hands& hands);
    void ready_and_shoot(const Screen& seen, Hands& hands);
    void lift(const Screen& seen, Hands& hands);
    void swing(const Screen& seen, Hands& hands);
    void fetch(const Screen& seen, Hands& hands);
    void brew(const Screen& seen, Hands& hands);

    // What the player does in the duel.
    void fight(const Screen& seen, Hands& hands);
    void search(const Screen& seen, Hands& hands);
    std::string best_wand(const Screen& seen) const;

    // Skills of any person who can use a mouse and a keyboard.
    bool aim(const Screen& seen, fvec2 place, float within, Hands& hands) const;
    void level(const Screen& seen, Hands& hands) const;
    void walk_to(const Screen& seen, fvec2 place, Hands& hands) const;
    bool take(const Screen& seen, const std::string& wand, Hands& hands) const;
    void walk(std::size_t way, Hands& hands) const;
    void hold(const std::string& control, Hands& hands) const;
    bool tap(int looks) const { return looks_ % (2 * looks) < looks; }

    MenuHand menu_hand_;
    Learnt learnt_;
    std::string confirm_{};      ///< key that confirms the chosen row, as the menu page says
    std::string words_{};        ///< text of the menu or lesson that was read last
    std::string wand_{};         ///< wand that the lesson is about
    int looks_ = 0;              ///< number of looks since the text in words_ appeared
    int pause_ = 0;              ///< number of looks for which the player is still reading
    int hung_ = 0, firing_ = 0;  ///< number of looks since a rope attached, and since fire was pressed
    int lost_ = 0;               ///< number of looks since the foe was last seen
    float above_ = 0;            ///< height above the foe at which a shot that flies in an arc is aimed (px)
    bool let_go_ = false;
    bool done_lessons_ = false;
    std::string result_{}, name_{}, bot_{};
};

}  // namespace thaum::game::screen
