// The tests of all parts of the page but the replay, in one process: they share one browser, and most one page.
import './browser.test.mjs';
import './opens.test.mjs';
import './tables.test.mjs';
import './charts.test.mjs';
import './save.test.mjs';
import './address.test.mjs';
import './reader.test.mjs';
import './legible.test.mjs';
import './hostile.test.mjs';
