// A pluck for each impact, as loud as its impulse.

let context;

/// To be called where a hand has asked for sound, as browsers want it.
export function allow() {
  context ??= new AudioContext();
  context.resume();
}

/// `loud` from 0 to 1; a cable has its own tone.
export function pluck(loud, cable) {
  if (!context || context.state !== "running" || loud < 0.01) return;
  const tone = context.createOscillator(), gain = context.createGain(), now = context.currentTime;
  tone.type = "triangle";
  tone.frequency.value = 220 * 2 ** ((5 * cable) / 12);
  gain.gain.setValueAtTime(0.25 * Math.sqrt(loud), now);
  gain.gain.exponentialRampToValueAtTime(1e-4, now + 0.35);
  tone.connect(gain).connect(context.destination);
  tone.start(now);
  tone.stop(now + 0.36);
}
