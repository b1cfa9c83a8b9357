package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.access.Fleet;
import org.dronemap.core.access.Gift;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.UserGroup;
import org.dronemap.core.organisation.Organisation;

/** Sort orders of organisations, groups, fleets, grants and gifts, the same in every kind of store. */
public final class GrantOrdering {
    public static final Comparator<Organisation> ORGANISATIONS = Comparator.comparing(
                    Organisation::name, String.CASE_INSENSITIVE_ORDER)
            .thenComparing(organisation -> organisation.id().value());
    public static final Comparator<UserGroup> GROUPS =
            Comparator.comparing(UserGroup::name, String.CASE_INSENSITIVE_ORDER).thenComparing(UserGroup::id);
    public static final Comparator<Fleet> FLEETS =
            Comparator.comparing(Fleet::name, String.CASE_INSENSITIVE_ORDER).thenComparing(Fleet::id);
    public static final Comparator<Grant> GRANTS =
            Comparator.comparing(Grant::madeAt).thenComparing(Grant::id);
    public static final Comparator<Gift> GIFTS =
            Comparator.comparing(Gift::at).thenComparing(gift -> gift.drone().value());

    private GrantOrdering() {}
}
