package org.dronemap.ws.mission;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** One step of a mission as clients read it: one that they may write, or one that was found on a vehicle alone. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(MissionItemRequest.class),
    @JsonSubTypes.Type(value = MissionItemView.Other.class, name = "other")
})
@Schema(name = "MissionItemView", description = "One step of a mission; which members there are depends on the type.")
public sealed interface MissionItemView permits MissionItemRequest, MissionItemView.Other {
    /** Something that the cloud does not plan itself. */
    @Schema(name = "OtherItem", description = "Something found on a vehicle that the cloud does not plan: read only.")
    record Other(@Schema(description = "What it is") String description) implements MissionItemView {}

    static MissionItemView of(MissionItem item) {
        return item instanceof MissionItem.Other other ? new Other(other.description()) : MissionItemRequest.of(item);
    }

    static List<MissionItemView> of(List<MissionItem> items) {
        return items.stream().map(MissionItemView::of).toList();
    }
}
