// The joints of PhysX that can be a cable.

/** Makes joints of `P`, the library; frees what it has handed over with `free`. */
export function jointMaker(P, physics) {
  const top = P.PxTopLevelFunctions.prototype, { PxD6AxisEnum: axis, PxD6MotionEnum: motion } = P, kept = [];
  const frame = ([x, y, z = 0]) => {
    const result = new P.PxTransform(P.PxIDENTITYEnum.PxIdentity), point = new P.PxVec3(x, y, z);
    result.p = point;
    P.destroy(point);
    kept.push(result);
    return result;
  };
  const linear = ["eX", "eY", "eZ"], angular = ["eTWIST", "eSWING1", "eSWING2"];
  return {
    /** PxDistanceJoint; `tolerance` [m] as shipped where it is not given. */
    distance(body, { anchor, attachment, length, other = null }, tolerance) {
      const joint = top.DistanceJointCreate(physics, other, frame(anchor), body, frame(attachment));
      joint.setMaxDistance(length);
      if (tolerance !== undefined) joint.setTolerance(tolerance);
      joint.setDistanceJointFlag(P.PxDistanceJointFlagEnum.eMAX_DISTANCE_ENABLED, true);
      return joint;
    },
    /** PxD6Joint: where its three linear axes are limited, one distance limits them, which has a restitution. */
    d6(body, { anchor, attachment, length, restitution }) {
      const joint = top.D6JointCreate(physics, null, frame(anchor), body, frame(attachment));
      this.limit(joint, true);
      for (const name of angular) joint.setMotion(axis[name], motion.eFREE);
      const spring = new P.PxSpring(0, 0), limit = new P.PxJointLinearLimit(length, spring);
      limit.restitution = restitution;
      limit.bounceThreshold = 0;
      joint.setDistanceLimit(limit);
      kept.push(spring, limit);
      return joint;
    },
    limit(joint, on) {
      for (const name of linear) joint.setMotion(axis[name], on ? motion.eLIMITED : motion.eFREE);
    },
    free: () => kept.forEach((object) => P.destroy(object)),
  };
}
