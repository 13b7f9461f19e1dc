// expect 10 20: 0 102 0
struct Ball {
    vec3 center; // of the ball
    float radius, weights[3];
};
struct Room { Ball ball; mat3 turn; bool open; highp int count; };
Room kept;
Room make() { Room room; return room; }
void fill(out Ball ball) { if (gl_FragCoord.x < 0.0) ball.radius = 1.0; }
void mainImage(out vec4 O, in vec2 I) {
    Room a = make(), b;
    Ball ball;
    fill(ball);
    if (I.x < 0.0) b.ball.radius = kept.turn[0].x = 2.0, b.open = true;
    float sum = a.ball.radius + a.ball.weights[2] + b.ball.center.x + b.turn[2].y + float(b.count) + ball.radius;
    O = vec4(sum, b.open ? 0.0 : 0.4, kept.turn[0].x, 1.0);
}
