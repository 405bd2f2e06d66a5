#pragma once

namespace tautline::bench {

/// How the parts of a picture look, on light paper and on dark.
inline constexpr const char* plot_style = R"(<style>
text{font:13px system-ui,sans-serif;fill:#1a1a1a}
.title{font-size:16px;font-weight:600}
.muted{fill:#555}
.paper{fill:#fff}
.frame{fill:none;stroke:#8a8a8a}
.grid{stroke:#e3e3e3}
.path{fill:none;stroke:#1f6fb4;stroke-width:1.2;stroke-linejoin:round}
.cable{fill:none;stroke:#1a1a1a;stroke-width:1.6}
.before{opacity:.55}
.slack{stroke-dasharray:6 4}
.body{fill:#9a9a9a;stroke:#1a1a1a;stroke-width:1.5;stroke-linejoin:round}
.bar{fill:none;stroke:#1a1a1a;stroke-width:7;stroke-linecap:round}
.core{fill:none;stroke:#bdbdbd;stroke-width:4;stroke-linecap:round}
.start .body,.start .core{fill:#fff}.start .core{stroke:#fff}
.faint{opacity:.22}
.centre{fill:#1a1a1a}
.impact{fill:none;stroke:#c4320a;stroke-width:1.1;opacity:.75}
.anchor{fill:#1a1a1a}
.scale{stroke:#1a1a1a;stroke-width:2}
.halo{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round;font-weight:600}
@media (prefers-color-scheme:dark){
text{fill:#eee}.muted{fill:#b5b5b5}.paper{fill:#16181c}.frame{stroke:#7d7d7d}.grid{stroke:#30343a}
.path{stroke:#6db3f2}.cable,.scale{stroke:#eee}.body{fill:#70757d;stroke:#eee}.bar{stroke:#eee}
.core{stroke:#50555c}.start .body{fill:#16181c}.start .core{stroke:#16181c;fill:none}
.centre,.anchor{fill:#eee}.impact{stroke:#ff9166}.halo{stroke:#16181c}
}
</style>
)";

}  // namespace tautline::bench
