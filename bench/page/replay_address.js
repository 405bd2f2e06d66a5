// The replay in the address: its case, its runs and its instant, so that a link shows what was seen.
(() => {
  'use strict';
  const { address, replay } = tautline;
  if (!replay) {
    return;
  }
  const { state } = replay;
  /// Instants are told to the tenth of a millisecond.
  const told = (time) => String(Number(time.toFixed(4)));
  let taking = true;

  /// What the address says: only what is another than what is shown, so that nothing starts anew.
  function take() {
    taking = true;
    const name = address.get('case') || replay.home.name; // without a choice, the pair of the picture
    const runs = address.get('replay.runs');
    if (name !== state.system.name) {
      replay.chooseCase(name);
    }
    if (runs && runs !== replay.runs().join(';')) {
      replay.chooseRuns(runs.split(';'));
    }
    const time = Number(address.get('replay.t'));
    if (address.get('replay.t') && Number.isFinite(time) && told(time) !== told(state.time)) {
      replay.show(time);
    }
    taking = false;
  }

  replay.started = () => address.listen(take, ['case', 'replay.runs', 'replay.t']);
  let later = 0;
  replay.changed = () => {
    if (taking) {
      return;
    }
    // a dragged slider is told once it rests
    clearTimeout(later);
    later = setTimeout(() => address.set({ 'replay.t': state.time > 0 ? told(state.time) : '',
      'replay.runs': replay.runs().join(';'),
      ...(address.get('case') || state.system !== replay.home ? { case: state.system.name } : {}) }), 150);
  };
})();
