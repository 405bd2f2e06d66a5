# for both precisions of Bullet
set(TAUTLINE_BULLET_SOURCES
  bounce_limit.cpp cable.cpp cable_constraint.cpp contact.cpp event.cpp plugin.cpp row.cpp
  two_phase.cpp world.cpp)
