package org.dronemap.ws.plan.topic;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.ws.plan.PlanJob;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.plan.PlanView;
import org.dronemap.ws.plan.PlanViewMapper;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about plans. */
final class PlanStreamTopic {
    private PlanStreamTopic() {}

    @JsonTypeName("plan")
    @Order(400)
    @Schema(name = "StreamPlanChanged", description = "A plan; all of them once after hello, then while it changes.")
    record PlanChanged(PlanView plan) implements StreamMessage.OfUseCase {}

    @JsonTypeName("planRemoved")
    @Order(410)
    @Schema(name = "StreamPlanRemoved", description = "A plan that was forgotten, or is out of your sight from now on.")
    record PlanRemoved(String id) implements StreamMessage.OfUseCase {}

    static StreamTopic<PlanJob> of(PlanJobExecutor plans) {
        return new StreamTopic<>(
                PlanChanged.class,
                new StreamTopicRate.Newest(4),
                new StreamTopic.SubjectMapping<>("plan", PlanJob::id),
                StreamTopic.Audience.of("whoever asked for it, and sees all of its drones", PlanService::isShownTo),
                (job, who) -> new PlanChanged(PlanViewMapper.whole(job)),
                plans::everybodys,
                new StreamTopic.Removal(PlanRemoved.class, PlanRemoved::new),
                feed -> plans.addListener(new PlanUpdates(plans, feed)));
    }

    private record PlanUpdates(PlanJobExecutor jobs, StreamTopicSink<PlanJob> feed)
            implements PlanJobExecutor.PlanListener {
        @Override
        public void changed(PlanJob job) {
            feed.changed(job.id(), () -> jobs.find(job.id()));
        }

        @Override
        public void removed(PlanJob job) {
            feed.removed(job.id());
        }
    }
}
