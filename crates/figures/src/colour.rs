//! One colour a role, so that a student learns it once; hues from the Okabe–Ito set, darkened on light paper and
//! lightened on dark paper until the contrast holds.
//!
//! Lines reach 3:1 against the paper, everything that may colour letters 4.5:1 (WCAG 2.1, 1.4.3 and 1.4.11). Areas
//! (paper, ground, the dark of a shadow, grid) are bounded by lines of another role, which carry the contrast.

use crate::style::Theme;

/// What a coloured thing means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// The canvas.
    Paper,
    /// The surface that receives shadows, as an area.
    Ground,
    /// Lines of a ground or chart grid.
    Grid,
    /// The dark of a shadow, as an area; [`Role::Shadow`] bounds it.
    Umbra,
    /// Letters.
    Text,
    /// Letters of less weight: ticks, notes.
    Note,
    /// Coordinate axes.
    Axis,
    /// The light: a sun, or parallel arrows when it is at infinity.
    Light,
    /// The eye.
    Eye,
    /// What casts a shadow.
    Occluder,
    /// The outline of what receives it.
    Receiver,
    /// The outline of a shadow.
    Shadow,
    /// Half shadow.
    Penumbra,
    /// A ray.
    Ray,
    /// A normal.
    Normal,
    /// What the algorithm chose.
    Chosen,
    /// What it rejected.
    Rejected,
    /// What is about to be decided.
    Undecided,
    /// A curve of a chart, counted from 0; curve 6 has the colour of curve 0.
    Curve(u8),
}

impl Role {
    /// Every role there is.
    pub const ALL: [Role; 24] = [
        Role::Paper,
        Role::Ground,
        Role::Grid,
        Role::Umbra,
        Role::Text,
        Role::Note,
        Role::Axis,
        Role::Light,
        Role::Eye,
        Role::Occluder,
        Role::Receiver,
        Role::Shadow,
        Role::Penumbra,
        Role::Ray,
        Role::Normal,
        Role::Chosen,
        Role::Rejected,
        Role::Undecided,
        Role::Curve(0),
        Role::Curve(1),
        Role::Curve(2),
        Role::Curve(3),
        Role::Curve(4),
        Role::Curve(5),
    ];

    /// Its colour as 0xRRGGBB.
    pub const fn rgb(self, theme: Theme) -> u32 {
        let (light, dark) = match self {
            Role::Paper => (0xFF_FF_FF, 0x14_18_1D),
            Role::Ground => (0xEE_F0_F3, 0x2A_31_39),
            Role::Grid => (0xD3_D8_DE, 0x40_49_53),
            Role::Umbra => (0xA3_AD_B8, 0x0F_13_18),
            Role::Text => (0x16_1B_21, 0xF1_F3_F5),
            Role::Note => (0x5A_63_6D, 0xA9_B2_BC),
            Role::Axis => (0x3C_44_4D, 0xC6_CD_D4),
            Role::Light => (0xC2_86_00, 0xF0_AB_14),
            Role::Eye => (0x00_00_00, 0xFF_FF_FF),
            Role::Occluder => (0x00_72_B2, 0x56_B4_E9),
            Role::Receiver => (0x6F_76_7C, 0x8B_94_9C),
            Role::Shadow => (0x4A_57_66, 0x96_A2_B0),
            Role::Penumbra => (0x6B_75_82, 0x7F_8B_98),
            Role::Ray => (0x9C_6C_00, 0xE6_9F_00),
            Role::Normal => (0x00_85_61, 0x1F_B8_8C),
            Role::Chosen => (0xC0_55_00, 0xF0_7A_2A),
            Role::Rejected => (0x6F_76_7C, 0x8B_94_9C),
            Role::Undecided => (0x16_1B_21, 0xF1_F3_F5),
            Role::Curve(n) => match n % 6 {
                0 => (0x00_72_B2, 0x56_B4_E9),
                1 => (0xC0_55_00, 0xF0_7A_2A),
                2 => (0x00_85_61, 0x1F_B8_8C),
                3 => (0xA1_50_80, 0xDB_8F_B9),
                4 => (0x8F_62_00, 0xE6_9F_00),
                _ => (0x4A_57_66, 0xC6_CD_D4),
            },
        };
        match theme {
            Theme::Light => light,
            Theme::Dark => dark,
        }
    }

    /// Whether it is an area without a contrast of its own.
    pub const fn is_area(self) -> bool {
        matches!(self, Role::Paper | Role::Ground | Role::Grid | Role::Umbra)
    }

    /// Whether letters may have its colour; the light's amber is for lines only.
    pub const fn may_colour_text(self) -> bool {
        !self.is_area() && !matches!(self, Role::Light)
    }
}

/// The colours of all roles: a theme's, on its own paper or on a colour of one's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Light or dark.
    pub theme: Theme,
    /// 0xRRGGBB instead of the theme's paper.
    pub paper: Option<u32>,
}

impl Palette {
    /// A role's colour as 0xRRGGBB.
    pub fn rgb(self, role: Role) -> u32 {
        let Some(paper) = self.paper else {
            return role.rgb(self.theme);
        };
        // Areas are the paper's own colour, a little nearer to letters; a shadow is darker.
        match role {
            Role::Paper => return paper,
            Role::Ground => return mixed(paper, Role::Text.rgb(self.theme), 0.08),
            Role::Grid => return mixed(paper, Role::Text.rgb(self.theme), 0.25),
            Role::Umbra => return mixed(paper, 0, 0.4),
            _ => {}
        }
        // Everything else goes towards white or black until it stands out as it does on the theme's paper.
        let wanted = if role.may_colour_text() { 4.5 } else { 3.0 };
        let far = match self.theme {
            Theme::Light => 0,
            Theme::Dark => 0xFF_FF_FF,
        };
        let towards = |step: u32| mixed(role.rgb(self.theme), far, f64::from(step) / 16.0);
        let reached = (0..16)
            .map(towards)
            .find(|&rgb| contrast(rgb, paper) >= wanted);
        reached.unwrap_or(far)
    }
}

/// From one colour to another, a channel at a time, rounded.
fn mixed(from: u32, to: u32, share: f64) -> u32 {
    let channel = |shift: u32| {
        let of = |rgb: u32| f64::from(rgb >> shift & 255);
        // In 0..=255 for shares in 0..=1.
        ((of(from) + (of(to) - of(from)) * share + 0.5) as u32) << shift
    };
    channel(16) | channel(8) | channel(0)
}

/// WCAG 2.1 relative luminance.
fn luminance(rgb: u32) -> f64 {
    let channel = |shift: u32| {
        let c = f64::from(rgb >> shift & 255) / 255.0;
        if c <= 0.040_45 {
            c / 12.92
        } else {
            libm::pow((c + 0.055) / 1.055, 2.4)
        }
    };
    0.2126 * channel(16) + 0.7152 * channel(8) + 0.0722 * channel(0)
}

/// WCAG 2.1 contrast ratio.
pub(crate) fn contrast(a: u32, b: u32) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

impl From<Theme> for Palette {
    fn from(theme: Theme) -> Palette {
        Palette { theme, paper: None }
    }
}

/// A role's colour, mixed with the paper and made see-through as asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// Whose colour.
    pub role: Role,
    /// Share of the role's colour, the rest is paper; 1 is the colour itself.
    pub share: f64,
    /// Opacity; 1 hides what is behind.
    pub alpha: f64,
}

impl Ink {
    /// The role's own colour.
    pub const fn of(role: Role) -> Ink {
        Ink {
            role,
            share: 1.0,
            alpha: 1.0,
        }
    }

    /// Mixed with paper; `share` is of the role.
    pub const fn tint(self, share: f64) -> Ink {
        Ink { share, ..self }
    }

    /// See-through.
    pub const fn alpha(self, alpha: f64) -> Ink {
        Ink { alpha, ..self }
    }

    /// The mixed colour as 0xRRGGBB, rounded a channel.
    pub fn rgb(self, palette: impl Into<Palette>) -> u32 {
        let palette = palette.into();
        let (colour, paper) = (palette.rgb(self.role), palette.rgb(Role::Paper));
        mixed(paper, colour, self.share.clamp(0.0, 1.0))
    }
}

impl From<Role> for Ink {
    fn from(role: Role) -> Ink {
        Ink::of(role)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contrast_formula_is_wcags() {
        // The standard's own extremes, and a grey worked by hand: 0x777777 on white is 4.48.
        assert!((contrast(0, 0xFF_FF_FF) - 21.0).abs() < 1e-12);
        assert!((contrast(0x77_77_77, 0xFF_FF_FF) - 4.48).abs() < 0.005);
    }

    #[test]
    fn every_role_stands_out_on_both_papers() {
        for &theme in Theme::ALL {
            for paper in [Role::Paper, Role::Ground] {
                for role in Role::ALL.into_iter().filter(|role| !role.is_area()) {
                    let reached = contrast(role.rgb(theme), paper.rgb(theme));
                    let wanted = match (role.may_colour_text(), paper) {
                        (true, Role::Paper) => 4.5,
                        // Labels on the ground have a rim of paper.
                        _ => 2.6,
                    };
                    let wanted = if paper == Role::Paper {
                        f64::max(wanted, 3.0)
                    } else {
                        wanted
                    };
                    assert!(
                        reached >= wanted,
                        "{role:?} on {paper:?}, {theme}: {reached:.2} < {wanted}"
                    );
                }
            }
        }
    }

    #[test]
    fn roles_stand_out_on_any_colour_of_paper() {
        for paper in [
            0x1E_5A_A0, 0, 0xFF_FF_FF, 0xC0_10_10, 0x80_80_80, 0xFF_FF_00, 0x00_40_20,
        ] {
            let theme = Theme::on(paper);
            let palette = Palette {
                theme,
                paper: Some(paper),
            };
            assert_eq!(palette.rgb(Role::Paper), paper);
            for role in Role::ALL.into_iter().filter(|role| !role.is_area()) {
                // Nothing reaches more than the better of black and white does.
                let most = contrast(0, paper).max(contrast(0xFF_FF_FF, paper));
                let wanted = if role.may_colour_text() { 4.5 } else { 3.0 };
                let reached = contrast(palette.rgb(role), paper);
                assert!(
                    reached >= f64::min(wanted, most),
                    "{role:?} on {paper:06x}: {reached}"
                );
            }
        }
    }

    #[test]
    fn a_shadow_is_darker_than_the_ground_it_lies_on() {
        for &theme in Theme::ALL {
            assert!(luminance(Role::Umbra.rgb(theme)) < luminance(Role::Ground.rgb(theme)));
        }
    }

    #[test]
    fn tints_run_from_paper_to_the_colour() {
        let ink = Ink::of(Role::Occluder);
        assert_eq!(ink.tint(0.0).rgb(Theme::Light), 0xFF_FF_FF);
        assert_eq!(ink.rgb(Theme::Light), 0x00_72_B2);
        // Halfway between 0x0072B2 and white, a channel at a time, half up: 127.5 184.5 216.5.
        assert_eq!(ink.tint(0.5).rgb(Theme::Light), 0x80_B9_D9);
        assert_eq!(ink.tint(f64::NAN).rgb(Theme::Light) >> 24, 0);
    }
}
