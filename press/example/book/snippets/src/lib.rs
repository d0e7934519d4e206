live::pages!(pendulum_pages::SCENES);
