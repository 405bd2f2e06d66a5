// The two kinds of cases that an engine is asked to run: a body in the plane, and a system in space.

import { plane } from "./plane.mjs";
import { space } from "./space.mjs";

export const kindOf = ({ bodies }) => (bodies ? space : plane);
