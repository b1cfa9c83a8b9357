package org.dronemap.proxy.signing;

import org.dronemap.core.access.LinkSigningPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The signing status of one drone: policy, key fingerprint, running key change and counts; no secrets.
 *
 * @param fingerprint of the key; null: there is none
 * @param proven the vehicle was heard using the key
 * @param nextFingerprint of a key that is being changed over to
 * @param change what is under way
 * @param safeLink a key may be sent over the present link; null: the drone has no link
 */
public record LinkSecurityStatus(
        LinkSigningPolicy policy,
        @Nullable String fingerprint,
        boolean proven,
        @Nullable String nextFingerprint,
        @Nullable KeyChangeKind change,
        SignatureCounts counts,
        @Nullable Boolean safeLink) {}
