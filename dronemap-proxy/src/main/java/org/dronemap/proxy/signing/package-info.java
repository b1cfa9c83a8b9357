/**
 * Keys of vehicles at work: which frames speak for a drone, how what goes out is signed, and how keys change.
 *
 * <p>Enters: what happens to keys while vehicles fly.
 *
 * <p>Never: bytes of signatures.
 */
@NullMarked
package org.dronemap.proxy.signing;

import org.jspecify.annotations.NullMarked;
