/**
 * Recordings in: a tlog played through the same sessions as a live link, with nothing sent.
 *
 * <p>Enters: what plays or keeps recordings.
 *
 * <p>Never: live links.
 */
@NullMarked
package org.dronemap.proxy.record;

import org.jspecify.annotations.NullMarked;
