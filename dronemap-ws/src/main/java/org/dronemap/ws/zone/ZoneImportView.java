package org.dronemap.ws.zone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.Zone;
import org.jspecify.annotations.Nullable;

/**
 * Answer to an import: the zones of a file that were added, and what of it was left out.
 *
 * @param leftOut the first 500 of them
 * @param leftOutTotal how many there are
 */
@Schema(name = "ZoneImportView", description = "The zones that were added, and what of the file was left out.")
public record ZoneImportView(
        @Schema(allowableValues = {"FeatureCollection"}) String type,
        List<ZoneFeature> features,

        @Schema(description = "What became no zone, or not with all that it has; the first 500")
        List<LeftOutView> leftOut,

        int leftOutTotal) {
    private static final int MOST_TOLD = 500;

    /**
     * A piece of a file that became no zone, or not with all that it has.
     *
     * @param at where in the file it stands, such as features[2]
     * @param name as the file has it
     * @param code as in problems
     * @param why a sentence
     */
    @Schema(name = "ZoneLeftOutView")
    public record LeftOutView(String at, @Nullable String name, String code, String why) {
        static LeftOutView of(ZoneFile.LeftOut piece) {
            return new LeftOutView(
                    piece.at(),
                    piece.name(),
                    piece.why().code().word(),
                    piece.why().sentence());
        }
    }

    static ZoneImportView of(List<Zone> zones, List<ZoneFile.LeftOut> leftOut, OrganisationId to) {
        return new ZoneImportView(
                "FeatureCollection",
                zones.stream().map(zone -> ZoneFeature.of(zone, to)).toList(),
                leftOut.stream().limit(MOST_TOLD).map(LeftOutView::of).toList(),
                leftOut.size());
    }
}
