/**
 * Sentences about what becomes of a drone that nobody commands.
 *
 * <p>Enters: a sentence, with the facts that it needs.
 *
 * <p>Never: what brings it about.
 */
@NullMarked
package org.dronemap.core.cloud.outlook;

import org.jspecify.annotations.NullMarked;
