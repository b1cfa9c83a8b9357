/**
 * Runs: plans that are flown under the eyes of the cloud, and their journals.
 *
 * <p>Enters: use cases about runs.
 *
 * <p>Never: how a run decides: that is cognitive.
 */
@NullMarked
package org.dronemap.ws.run;

import org.jspecify.annotations.NullMarked;
